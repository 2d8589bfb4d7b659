// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The sentences of a Micro-Modem.

#include "hooks/micro_modem/codec.h"
#include "tests/fuzz/micro_modem_hostile.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace glider::hooks::micro_modem {
namespace {

using Bodies = std::vector<std::string>;

template <typename Message>
std::string written(const Message& message) {
  char bytes[256];
  return {bytes, encode(message, bytes, sizeof bytes)};
}

/// The sentence with this body, by a sum of its own.
std::string sentence(const std::string& body) {
  int sum = 0;
  for (const char c : body) {
    sum ^= c;
  }
  char end[8];
  std::snprintf(end, sizeof end, "*%02X\r\n", static_cast<unsigned>(sum));
  return "$" + body + end;
}

Bodies bodiesIn(const std::string& bytes, uint32_t* bad = nullptr) {
  SentenceReader reader;
  Bodies bodies;
  for (const char byte : bytes) {
    if (reader.push(static_cast<uint8_t>(byte))) {
      bodies.emplace_back(reader.body(), reader.size());
    }
  }
  if (bad != nullptr) {
    *bad = reader.bad();
  }
  return bodies;
}

Text asText(const std::string& text) {
  return {text.data(), static_cast<uint32_t>(text.size())};
}

template <typename Message>
bool isOne(const std::string& body) {
  Message message;
  return decode(asText(body), message);
}

Data dataOf(const std::vector<uint8_t>& bytes) {
  Data data;
  for (const uint8_t byte : bytes) {
    data.bytes[data.size++] = byte;
  }
  return data;
}

struct Case {
  std::string line;  ///< without its line end
  std::string written;
};

// The sums of the first three are published; the others were computed apart.
TEST(MicroModem, SentencesAreWrittenAsTheModemExpectsThem) {
  const std::vector<Case> cases = {
      {"$CCCYC,0,1,2,0,1,1*5A", written(StartCycle{1, 2, 0, true, 1})},
      {"$CCTXD,1,2,1,48656C6C6F*05",
       written(Transmit{1, 2, true, dataOf({'H', 'e', 'l', 'l', 'o'})})},
      {"$CCMUC,1,2,1FFF*03", written(SendMiniPacket{1, 2, 0x1FFF})},
      {"$CCCFG,SRC,1*31", written(SetSetting{textOf("SRC"), 1})},
      {"$CACFG,SRC,1*33", written(SettingIs{textOf("SRC"), 1})},
      {"$CACYC,0,1,2,0,1,1*58", written(CycleStarts{1, 2, 0, true, 1})},
      {"$CADRQ,235958,1,0,0,32,1*44", written(DataRequest{86398, 1, 0, false, 32, 1})},
      {"$CARXD,2,0,0,1,00FF10*62", written(Received{2, 0, false, 1, dataOf({0, 0xFF, 0x10})})},
      {"$CAMSG,BAD_CRC,1*20", written(Damaged{1})},
      {"$CAACK,2,1,1,1*48", written(Acknowledged{2, 1, 1, true})},
      {"$CATXF,32*65", written(TransmitEnds{32})},
      {"$CAMUA,1,2,0ABC*04", written(MiniPacketReceived{1, 2, 0xABC})},
      {"$CAERR,120000,TXD,7*17", written(Refusal{textOf("120000,TXD,7")})},
      {"$CAREV,120000,AUV,0.93.0.48*06", written(Revision{textOf("120000,AUV,0.93.0.48")})},
      {"$CCTXD,1,0,0,*79", written(Transmit{1, 0, false, {}})},
  };
  for (const Case& one : cases) {
    EXPECT_EQ(one.written, one.line + "\r\n");
  }
}

TEST(MicroModem, SentencesAreRead) {
  const Bodies bodies = bodiesIn("$CADRQ,010203,15,2,1,32,8*7B\r\n$CARXD,2,0,1,3,48656c*3A\r\n");
  ASSERT_EQ(bodies.size(), 2U);
  DataRequest request;
  ASSERT_TRUE(decode(asText(bodies[0]), request));
  EXPECT_EQ(request.time_s, 3723U);
  EXPECT_EQ(request.source, 15U);
  EXPECT_EQ(request.destination, 2U);
  EXPECT_TRUE(request.acknowledge);
  EXPECT_EQ(request.bytes, 32U);
  EXPECT_EQ(request.frame, 8U);
  Received received;
  ASSERT_TRUE(decode(asText(bodies[1]), received));
  EXPECT_EQ(received.source, 2U);
  EXPECT_EQ(received.destination, 0U);
  EXPECT_TRUE(received.acknowledge);
  EXPECT_EQ(received.frame, 3U);
  ASSERT_EQ(received.data.size, 3U);
  EXPECT_EQ(std::string(received.data.bytes, received.data.bytes + 3), "Hel");
  DataRequest leap;
  const std::string leap_body = "CADRQ,235960,1,2,1,32,1";
  ASSERT_TRUE(decode(asText(leap_body), leap));
  EXPECT_EQ(leap.time_s, 86399U);
  SettingIs setting;
  const std::string body = "CACFG,SRC,12";
  ASSERT_TRUE(decode(asText(body), setting));
  EXPECT_EQ(setting.name, textOf("SRC"));
  EXPECT_EQ(setting.value, 12U);
  MiniPacketReceived mini;
  const std::string mini_body = "CAMUA,3,4,1aBc";
  ASSERT_TRUE(decode(asText(mini_body), mini));
  EXPECT_EQ(mini.bits, 0x1ABCU);
}

TEST(MicroModem, BothSpellingsOfADamagedFrameAreRead) {
  for (const char* body : {"CAMSG,BAD_CRC,2", "CAMSG,Bad CRC,2"}) {
    Damaged damaged;
    const std::string text = body;
    ASSERT_TRUE(decode(asText(text), damaged)) << body;
    EXPECT_EQ(damaged.frame, 2U);
  }
  EXPECT_FALSE(isOne<Damaged>("CAMSG,PACKET_TIMEOUT,2"));
}

TEST(MicroModem, AnEchoOfTheHostIsNoAnswer) {
  EXPECT_TRUE(isOne<SetSetting>("CCCFG,SRC,1"));
  EXPECT_FALSE(isOne<SettingIs>("CCCFG,SRC,1"));
  EXPECT_FALSE(isOne<SetSetting>("CACFG,SRC,1"));
  EXPECT_FALSE(isOne<CycleStarts>("CCCYC,0,1,2,0,1,1"));
  EXPECT_FALSE(isOne<StartCycle>("CACYC,0,1,2,0,1,1"));
  EXPECT_FALSE(isOne<MiniPacketReceived>("CCMUC,1,2,0001"));
  EXPECT_FALSE(isOne<SendMiniPacket>("CAMUA,1,2,0001"));
}

template <typename Message>
void expectRefused(const Bodies& bodies) {
  for (const std::string& body : bodies) {
    EXPECT_FALSE(isOne<Message>(body)) << body;
  }
}

TEST(MicroModem, AFieldThatIsNotWhatItShouldBeIsRefused) {
  expectRefused<StartCycle>({"CCCYC",
                             "CCCYC,0,1,2,0,1",
                             "CCCYC,0,1,2,0,1,1,",
                             "CCCYC,0,1,2,0,1,1,1",
                             "CCCYC,1,1,2,0,1,1",
                             "CCCYC,0,16,2,0,1,1",
                             "CCCYC,0,1,16,0,1,1",
                             "CCCYC,0,1,2,6,1,1",
                             "CCCYC,0,1,2,0,2,1",
                             "CCCYC,0,1,2,0,1,0",
                             "CCCYC,0,1,2,0,1,9",
                             "CCCYC,0,,2,0,1,1",
                             "CCCYC,0,+1,2,0,1,1",
                             "CCCYC,0,-1,2,0,1,1",
                             "CCCYC,0,1.0,2,0,1,1",
                             "CCCYC,0,1 ,2,0,1,1",
                             "CCCYC,0,000001,2,0,1,1",
                             "CCCYC,0,4294967297,2,0,1,1",
                             "cccyc,0,1,2,0,1,1",
                             ""});
  expectRefused<Transmit>({"CCTXD,1,2,1", "CCTXD,1,2,1,4", "CCTXD,1,2,1,4G", "CCTXD,1,2,1,G4",
                           "CCTXD,1,2,1,48,", "CCTXD,1,2,1,48 65",
                           "CCTXD,1,2,1," + std::string(66, '0')});
  EXPECT_TRUE(isOne<Transmit>("CCTXD,1,2,1," + std::string(64, '0')));
  EXPECT_TRUE(isOne<Transmit>("CCTXD,1,2,1,"));
  // The byte after the body would be a digit.
  const std::string longer = "CCTXD,1,2,1,4865";
  Transmit transmit;
  EXPECT_FALSE(decode({longer.data(), static_cast<uint32_t>(longer.size() - 1)}, transmit));
  expectRefused<DataRequest>(
      {"CADRQ,240000,1,2,1,32,1", "CADRQ,006000,1,2,1,32,1", "CADRQ,000061,1,2,1,32,1",
       "CADRQ,12000,1,2,1,32,1", "CADRQ,1200000,1,2,1,32,1", "CADRQ,12:000,1,2,1,32,1",
       "CADRQ,120000,16,2,1,32,1", "CADRQ,120000,1,16,1,32,1", "CADRQ,120000,1,2,2,32,1",
       "CADRQ,120000,1,2,1,257,1", "CADRQ,120000,1,2,1,32,0", "CADRQ,120000,1,2,1,32,9"});
  expectRefused<Received>({"CARXD,16,2,1,1,48", "CARXD,1,16,1,1,48", "CARXD,1,2,2,1,48",
                           "CARXD,1,2,1,0,48", "CARXD,1,2,1,9,48", "CARXD,1,2,1,1,4",
                           "CARXD,1,2,1,1"});
  expectRefused<SetSetting>({"CCCFG,SRC", "CCCFG,,1", "CCCFG,SR C,1", "CCCFG,SRCSRCSRC,1",
                             "CCCFG,SRC,65536", "CCCFG,SRC,1,1"});
  expectRefused<SendMiniPacket>({"CCMUC,1,2,2000", "CCMUC,1,2,FFF", "CCMUC,1,2,00FFF",
                                 "CCMUC,1,2,0G00", "CCMUC,16,2,0000", "CCMUC,1,16,0000"});
  expectRefused<Damaged>({"CAMSG,BAD_CRC", "CAMSG,BAD_CRC,0", "CAMSG,BAD_CRC,9"});
  expectRefused<Acknowledged>({"CAACK,16,1,1,1", "CAACK,1,16,1,1", "CAACK,1,1,0,1", "CAACK,1,1,9,1",
                               "CAACK,1,1,1,2", "CAACK,1,1,1"});
  expectRefused<TransmitEnds>({"CATXF", "CATXF,", "CATXF,65536", "CATXF,1,2"});
  expectRefused<Refusal>({"CAERR", "CAERRX,1"});
}

TEST(MicroModem, WhatNoModemWouldReadIsNotWritten) {
  EXPECT_EQ(written(StartCycle{16, 2, 0, true, 1}), "");
  EXPECT_EQ(written(StartCycle{1, 16, 0, true, 1}), "");
  EXPECT_EQ(written(StartCycle{1, 2, 6, true, 1}), "");
  EXPECT_EQ(written(StartCycle{1, 2, 0, true, 0}), "");
  EXPECT_EQ(written(StartCycle{1, 2, 0, true, 9}), "");
  EXPECT_EQ(written(SendMiniPacket{1, 2, 0x2000}), "");
  EXPECT_EQ(written(DataRequest{86400, 1, 2, true, 32, 1}), "");
  EXPECT_EQ(written(SetSetting{textOf(""), 1}), "");
  EXPECT_EQ(written(SetSetting{textOf("S,C"), 1}), "");
  EXPECT_EQ(written(SetSetting{textOf("SRCSRCSRC"), 1}), "");
  EXPECT_EQ(written(SetSetting{textOf("SRC"), 65536}), "");
  for (const char* text : {"a$b", "a*b", "a\nb", "a\x7F", "\xC3\xA4"}) {
    EXPECT_EQ(written(Refusal{textOf(text)}), "") << text;
  }
  Transmit transmit{1, 2, true, {}};
  transmit.data.size = kMostFrameBytes + 1;
  EXPECT_EQ(written(transmit), "");
}

TEST(MicroModem, ASentenceNeedsItsRoom) {
  Received longest{15, 15, true, 8, {}};
  longest.data.size = kMostFrameBytes;
  const std::string whole = written(longest);
  ASSERT_EQ(whole.size(), 86U);
  ASSERT_LE(whole.size(), kMostSentence);
  std::string bytes(whole.size() + 1, '#');
  EXPECT_EQ(encode(longest, bytes.data(), static_cast<uint32_t>(whole.size())), whole.size());
  EXPECT_EQ(bytes, whole + "#");
  bytes.assign(bytes.size(), '#');
  EXPECT_EQ(encode(longest, bytes.data(), static_cast<uint32_t>(whole.size() - 1)), 0U);
  EXPECT_EQ(bytes.substr(whole.size() - 1), "##");
}

uint32_t below(std::mt19937& random, size_t bound) {
  return static_cast<uint32_t>(random() % bound);
}

Data randomData(std::mt19937& random) {
  Data data;
  data.size = below(random, kMostFrameBytes + 1);
  for (uint32_t i = 0; i < data.size; ++i) {
    data.bytes[i] = static_cast<uint8_t>(random());
  }
  return data;
}

TEST(MicroModem, DataGoThrough) {
  std::mt19937 random(3);
  for (int i = 0; i < 2000; ++i) {
    const Received sent{below(random, 16), below(random, 16), below(random, 2) == 0,
                        1 + below(random, 8), randomData(random)};
    const Bodies bodies = bodiesIn(written(sent));
    ASSERT_EQ(bodies.size(), 1U);
    Received heard;
    ASSERT_TRUE(decode(asText(bodies[0]), heard));
    EXPECT_EQ(heard.source, sent.source);
    EXPECT_EQ(heard.destination, sent.destination);
    EXPECT_EQ(heard.acknowledge, sent.acknowledge);
    EXPECT_EQ(heard.frame, sent.frame);
    ASSERT_EQ(heard.data.size, sent.data.size);
    EXPECT_EQ(std::memcmp(heard.data.bytes, sent.data.bytes, sent.data.size), 0);
  }
}

/// One of each kind of sentence.
std::string randomSentence(std::mt19937& random) {
  const uint32_t from = below(random, 16), to = below(random, 16), frame = 1 + below(random, 8);
  const bool ack = below(random, 2) == 0;
  switch (below(random, 10)) {
    case 0:
      return written(SetSetting{textOf("SRC"), below(random, 65536)});
    case 1:
      return written(CycleStarts{from, to, below(random, 6), ack, frame});
    case 2:
      return written(SendMiniPacket{from, to, below(random, 0x2000)});
    case 3:
      return written(Transmit{from, to, ack, randomData(random)});
    case 4:
      return written(DataRequest{below(random, 86400), from, to, ack, below(random, 257), frame});
    case 5:
      return written(Damaged{frame});
    case 6:
      return written(Acknowledged{from, to, frame, ack});
    case 7:
      return written(TransmitEnds{below(random, 65536)});
    case 8:
      return written(Revision{textOf("120000,AUV,0.93")});
    default:
      return written(Received{from, to, ack, frame, randomData(random)});
  }
}

bool isAMessage(const std::string& body) {
  bool any = false;
#define MODEM_SENTENCE(name) any = any || isOne<name>(body);
#include "hooks/micro_modem/messages.def"
#undef MODEM_SENTENCE
  return any;
}

TEST(MicroModem, EveryDamagedByteIsSeen) {
  for (const std::string& line :
       {sentence("CARXD,2,0,0,1,48656C6C6F"), sentence("CCCYC,0,1,2,0,1,1"),
        sentence("CADRQ,235959,1,0,0,32,1"), sentence("CAMSG,BAD_CRC,1")}) {
    for (size_t i = 0; i + 2 < line.size(); ++i) {  // the line end is of no account
      for (int other = 0; other < 256; ++other) {
        std::string wrong = line;
        wrong[i] = static_cast<char>(other);
        const bool same_digit =
            i + 4 >= line.size() && (other | 0x20) == (line[i] | 0x20) && std::isxdigit(other) != 0;
        if (wrong == line || same_digit) {
          continue;
        }
        for (const std::string& body : bodiesIn(wrong)) {
          EXPECT_FALSE(isAMessage(body)) << wrong;
        }
      }
    }
  }
}

TEST(MicroModem, SentencesAreFoundInWhatEverSurroundsThem) {
  const std::string one = sentence("CATXF,1"), two = sentence("CATXF,2");
  EXPECT_EQ(bodiesIn(one + two), Bodies({"CATXF,1", "CATXF,2"}));
  EXPECT_EQ(bodiesIn("\xFF\x00noise*41" + one), Bodies({"CATXF,1"}));
  uint32_t bad = 0;
  EXPECT_EQ(bodiesIn(one.substr(0, 5) + two, &bad), Bodies({"CATXF,2"}));
  EXPECT_EQ(bad, 1U);
  EXPECT_EQ(bodiesIn("$CATXF,1*00\r\n" + two, &bad), Bodies({"CATXF,2"}));
  EXPECT_EQ(bad, 1U);
  EXPECT_EQ(bodiesIn("$" + std::string(3000, 'x') + two, &bad), Bodies({"CATXF,2"}));
  EXPECT_EQ(bad, 1U);
  for (const char* body : {"CATXF\x7F,1", "CATXF\x1F,1"}) {
    EXPECT_EQ(bodiesIn(sentence(body) + two, &bad), Bodies({"CATXF,2"}));
    EXPECT_EQ(bad, 1U);
  }
  const std::string longest = "CAREV," + std::string(994, 'x');
  EXPECT_EQ(bodiesIn(sentence(longest)), Bodies({longest}));
  EXPECT_EQ(bodiesIn(sentence(longest + "x")), Bodies());
  // Without line ends.
  EXPECT_EQ(bodiesIn(one.substr(0, one.size() - 2) + two), Bodies({"CATXF,1", "CATXF,2"}));
}

/// A share of what tests/fuzz/micro_modem_fuzzer.cpp does.
TEST(MicroModemHostile, StreamsAreReadAsASlowReaderReadsThem) {
  std::mt19937 random(7);
  for (int done = 0; done < 2000; ++done) {
    std::string stream;
    for (int i = 0; i < 8; ++i) {
      std::string line = randomSentence(random);
      ASSERT_NE(line, "");
      EXPECT_TRUE(isAMessage(line.substr(1, line.size() - 6))) << line;
      if (below(random, 4) == 0) {
        line.resize(below(random, line.size()));
      } else if (below(random, 4) == 0) {
        line[below(random, line.size())] ^= static_cast<char>(1U << below(random, 8));
      }
      stream += line;
      for (uint32_t n = below(random, 12); n > 8; --n) {
        stream += "$*\n,A0"[below(random, 6)];
      }
    }
    micro_modem_hostile::requireReader(stream);
  }
}

}  // namespace
}  // namespace glider::hooks::micro_modem
