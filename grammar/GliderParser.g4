// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The mission language, whole (docs/language.md). Newlines are free. frontend/parse repairs and reports the usual
// mistakes on the tokens before this grammar sees them, so it describes right missions only.
parser grammar GliderParser;
options { tokenVocab = GliderLexer; }

file : item* EOF ;

item
  : missionLine | platformLine | importLine
  | constant | parameter | variable
  | always | state | behaviour | external | place | requirement | assumption | resumption | nap | declination | share
  | vehicles | pack | choice | preference
  ;

missionLine : MISSION anyName ;
platformLine : PLATFORM name ;
importLine : IMPORT STRING (AS name)? ;

constant : CONST anyName (COLON type)? ASSIGN expr ;
parameter : PARAM anyName size? COLON type ASSIGN expr range? (WHERE expr)? ;
variable : VAR anyName size? COLON type ASSIGN expr range? ;
// How many elements an array has.
size : LBRACKET expr RBRACKET ;
range : IN expr RANGE expr ;
type : name ((TIMES | DIVIDE) name)* ;

always : ALWAYS eventCase+ ;
state : STATE anyName formals? BEGIN member* END ;
behaviour : (FLIGHTPROFILE | FLIGHTROUTE) name formals? BEGIN member* END ;
formals : LPAREN (formal (COMMA formal)*)? RPAREN ;
formal : anyName COLON type (ASSIGN expr)? range? ;

member
  : FLIGHTROUTE use       # routeMember
  | FLIGHTPROFILE use     # profileMember
  | SENSORS sensorItem (COMMA sensorItem)*  # sensorsMember
  | SAMPLE sampleItem (COMMA sampleItem)*   # sampleMember
  | variable              # variableMember
  | ENTRY block           # entryMember
  | EVENTS eventCase*     # eventsMember
  ;
sensorItem : (anyName | HEARD) (EVERY expr)? ;
// How often an instrument reads: `ctd every 4 s`, `optode every 30 s on climbs below 10 m one yo in 3`, `fluorometer off`.
sampleItem : anyName (OFF | EVERY expr)? samplePart* ;
samplePart : WHEN expr | ON (CLIMBS | DIVES) | (BELOW | ABOVE) expr | ONE YO IN expr ;
use : name arguments? ;
target : anyName arguments? ;

eventCase : CASE expr block? transition ;
transition : GOTO target | CALL target | RETURN | EXIT | STAY | DONE ;

block : DO statement* END ;
statement
  : SET name (LBRACKET expr RBRACKET)? ASSIGN expr         # setStatement
  | IF expr THEN statement* (ELSE statement*)? END         # ifStatement
  | FOR anyName IN expr RANGE expr block                   # forStatement
  | LOG STRING (COMMA expr)*                               # logStatement
  | NAME arguments                                         # commandStatement
  ;

external : EXTERN declaration ;
declaration
  : FUNCTION name formals COLON type range?                # externFunction
  | (FLIGHTPROFILE | FLIGHTROUTE) name formals? reads?     # externBehaviour
  | SENSOR name COLON type range? (STALE AFTER expr)?      # externSensor
  ;
reads : READS name (COMMA name)* ;

resumption : RESUME WITHIN expr (COMMA NEVER AFTER RESTART)? ;
// How long the SBC may sleep between two ticks: `nap at most 4 min`.
nap : NAP AT MOST expr ;
declination : DECLINATION expr ;

place : PLACE anyName ASSIGN expr ;

// What other vehicles receive; with a type it declares the variable.
share : SHARE anyName (COLON type (ASSIGN expr)?)? range? (PRECISION expr)? EVERY expr (STALE AFTER expr)? ;

// The names of a fleet, in the order of the addresses of their modems.
vehicles : VEHICLES anyName (COMMA anyName)* ;

// The batteries: `pack 168 Ah at 14.4 V reserve 20 %`.
pack : PACK expr AT expr (RESERVE expr)? ;

// What `glidercc plan` chooses: `choose bottom : length in 60 m .. 180 m by 10 m`.
choice : CHOOSE anyName COLON type (ASSIGN expr)? range (BY expr)? (WHERE expr)? (AT LAUNCH)? ;
// What it prefers, the most important first.
preference : PREFER objective (THEN objective)* ;
objective : (LEAST | GREATEST) expr | ENDURANCE ;

assumption : ASSUME premise ;
premise
  : START expr                       # startPremise
  | NO OUTAGE                        # noOutagePremise
  | OUTAGE LE expr                   # outagePremise
  | CURRENT LE expr                  # currentPremise
  | (KNOWN name | FIX) EVERY expr    # knownPremise
  | name CHANGES LE expr             # changesPremise
  | name range                       # rangePremise
  | expr (name arguments)?           # conditionPremise
  ;

requirement : REQUIRE promise ;
promise
  : ALWAYS expr              # alwaysPromise
  | EXIT WITHIN expr         # exitPromise
  | STACK LE expr            # stackPromise
  | CAN? REACH anyName       # reachPromise
  | SURFACES EVERY expr      # surfacesPromise
  | scope? pattern (OR_WORD EXIT)?  # patternPromise
  ;
scope
  : (IN | OUTSIDE | BEFORE | AFTER) somewhere COLON
  | FROM somewhere TO somewhere COLON
  ;
pattern
  : VISIT route manner? WITHIN expr                              # visitPattern
  | VISIT somewhere AT MOST expr TIMES_WORD                      # atMostPattern
  | VISIT somewhere (AT LEAST | EXACTLY) expr TIMES_WORD WITHIN expr  # countPattern
  | PATROL route manner? EVERY expr                              # patrolPattern
  | NEVER somewhere ((BEFORE | AFTER) somewhere)?                # neverPattern
  | (WHENEVER (AND_WORD ONLY WHEN)? | WHEN) somewhere THEN somewhere timing?  # reactionPattern
  | HOLD somewhere UNTIL somewhere WITHIN expr                   # holdPattern
  ;
route : somewhere (COMMA somewhere)* | somewhere (THEN somewhere)+ ;
manner : IN STRICT? ORDER | FAIRLY ;
timing : WITHIN expr | FOR expr | NEXT TICK ;
// A state, a place or a condition. A state may have the name of a unit.
somewhere : expr | UNIT | COMPASS | MIN ;

expr
  : primary                                        # primaryExpr
  | (MINUS | NOT) expr                             # unaryExpr
  | expr (TIMES | DIVIDE) expr                     # binaryExpr
  | expr (PLUS | MINUS) expr                       # binaryExpr
  | expr (LT | LE | GT | GE | EQ | NE) expr        # binaryExpr
  | NOT_WORD expr                                  # unaryExpr
  | expr AND expr                                  # binaryExpr
  | expr OR expr                                   # binaryExpr
  ;
// A NUMBER before N, S, E or W may be degrees and minutes, `39 10.5`: frontend/parse joins the two.
primary
  : NUMBER unit? (NUMBER COMPASS)?                 # literal
  | NUMBER unitName (NUMBER (UNIT | MIN))+         # duration
  | INSTANT                                        # instant
  | (TRUE | FALSE)                                 # truth
  | LPAREN expr RPAREN                             # parenthesis
  | LBRACKET (expr (COMMA expr)*)? RBRACKET        # list
  | name LBRACKET expr RBRACKET                    # index
  | (name | MIN) arguments                         # invocation
  | (name | HEARD)                                 # nameUse
  | PEERS WITHIN primary                           # peersWithin
  ;
unit : unitName ((TIMES | DIVIDE) unitName)* ;
unitName : UNIT | COMPASS | MIN ;
arguments : LPAREN (argument (COMMA argument)*)? RPAREN ;
argument : (name ASSIGN)? expr (OF name)? ;

name
  : NAME | IN | OF | WHERE | DONE | FUNCTION | SENSOR | READS | WITHIN | STACK | REACH | NEVER | AFTER | STALE
  | SURFACES | RESUME | DECLINATION | RESTART | PLACE | CAN | VISIT | PATROL | STRICT | ORDER | FAIRLY | AT | MOST
  | LEAST | EXACTLY | TIMES_WORD | BEFORE | WHENEVER | WHEN | ONLY | NEXT | TICK | FOR | HOLD | UNTIL | OUTSIDE
  | FROM | TO | ASSUME | START | NO | OUTAGE | CURRENT | KNOWN | FIX | AS | CHANGES | SHARE | PRECISION
  | VEHICLES | PEERS | PACK | RESERVE | CHOOSE | BY | LAUNCH | PREFER | GREATEST | ENDURANCE | OFF | ON | CLIMBS | DIVES | BELOW
  | ABOVE | ONE | NAP
  ;
// A unit's name may name a mission or a state; elsewhere the frontend says why not.
anyName : name | UNIT | COMPASS | MIN ;
