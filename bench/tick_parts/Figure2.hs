-- SPDX-FileCopyrightText: 2026 The glidercc authors
-- SPDX-License-Identifier: Apache-2.0

-- Figure 2's transitions as streams: Copilot makes figure2.c of them. States: 0 s1, 1 s2, 2 s3, 3 ended.
module Main where

import Copilot.Compile.C99 (compile)
import Language.Copilot
import Prelude hiding (mod, (&&), (++), (/=), (<), (==), (>=))

time :: Stream Double
time = extern "time_s" Nothing

current :: Stream Word8
current = [0] ++ after

after :: Stream Word8
after =
  mux (current == 0 && time >= 2000) 2 $
  mux (current == 0 && time >= 500 && time < 1500) 1 $
  mux (current == 1 && time >= 1500) 0 $
  mux (current == 2 && time >= 2500) 3 current

main :: IO ()
main = reify (trigger "transition" (after /= current) [arg after]) >>= compile "figure2"
