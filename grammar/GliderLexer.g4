// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The words of the mission language. The input is bytes: everything outside ASCII is legal in comments and strings
// only. What is never right (an open comment, a foreign character, a wrong operator) is a token of its own, so that
// frontend/parse can name the mistake and go on.
lexer grammar GliderLexer;

// `yo` in `one yo in 3`, elsewhere a name (frontend/parse/lexeme.cpp).
tokens { YO }

// Hard keywords: these name nothing.
MISSION : 'mission' ;
PLATFORM : 'platform' ;
IMPORT : 'import' ;
CONST : 'const' ;
PARAM : 'param' ;
VAR : 'var' ;
ALWAYS : 'always' ;
STATE : 'state' ;
BEGIN : 'begin' ;
END : 'end' ;
FLIGHTROUTE : 'flightroute' ;
FLIGHTPROFILE : 'flightprofile' ;
SENSORS : 'sensors' ;
SAMPLE : 'sample' ;  // only before a name (frontend/parse/lexeme.cpp); elsewhere it is one
EVENTS : 'events' ;
CASE : 'case' ;
GOTO : 'goto' ;
CALL : 'call' ;
RETURN : 'return' ;
EXIT : 'exit' ;
STAY : 'stay' ;
ENTRY : 'entry' ;
DO : 'do' ;
SET : 'set' ;
IF : 'if' ;
THEN : 'then' ;
ELSE : 'else' ;
LOG : 'log' ;
EXTERN : 'extern' ;
REQUIRE : 'require' ;
EVERY : 'every' ;
TRUE : 'true' ;
FALSE : 'false' ;
AND_WORD : 'and' ;
OR_WORD : 'or' ;
NOT_WORD : 'not' ;

// Soft keywords: words of the language in one place, names everywhere else (rule `name` of the parser).
IN : 'in' ;
OF : 'of' ;
WHERE : 'where' ;
DONE : 'done' ;
FUNCTION : 'function' ;
SENSOR : 'sensor' ;
READS : 'reads' ;
WITHIN : 'within' ;
STACK : 'stack' ;
REACH : 'reach' ;
NEVER : 'never' ;
AFTER : 'after' ;
STALE : 'stale' ;
SURFACES : 'surfaces' ;
RESUME : 'resume' ;
DECLINATION : 'declination' ;
RESTART : 'restart' ;
PLACE : 'place' ;
CAN : 'can' ;
VISIT : 'visit' ;
PATROL : 'patrol' ;
STRICT : 'strict' ;
ORDER : 'order' ;
FAIRLY : 'fairly' ;
AT : 'at' ;
MOST : 'most' ;
LEAST : 'least' ;
EXACTLY : 'exactly' ;
TIMES_WORD : 'times' ;
BEFORE : 'before' ;
WHENEVER : 'whenever' ;
WHEN : 'when' ;
ONLY : 'only' ;
NEXT : 'next' ;
TICK : 'tick' ;
FOR : 'for' ;
HOLD : 'hold' ;
UNTIL : 'until' ;
OUTSIDE : 'outside' ;
FROM : 'from' ;
TO : 'to' ;
ASSUME : 'assume' ;
START : 'start' ;
NO : 'no' ;
OUTAGE : 'outage' ;
CURRENT : 'current' ;
KNOWN : 'known' ;
FIX : 'fix' ;
AS : 'as' ;
CHANGES : 'changes' ;
SHARE : 'share' ;
PRECISION : 'precision' ;
VEHICLES : 'vehicles' ;
PEERS : 'peers' ;
PACK : 'pack' ;
RESERVE : 'reserve' ;
CHOOSE : 'choose' ;
BY : 'by' ;
LAUNCH : 'launch' ;
PREFER : 'prefer' ;
GREATEST : 'greatest' ;
ENDURANCE : 'endurance' ;
OFF : 'off' ;
ON : 'on' ;
CLIMBS : 'climbs' ;
DIVES : 'dives' ;
BELOW : 'below' ;
ABOVE : 'above' ;
ONE : 'one' ;
NAP : 'nap' ;

// Units (support/units/units.def) and the letters of positions; `S` and `W` are both. `min` is also the function.
MIN : 'min' ;
UNIT : 'mm' | 'cm' | 'm' | 'km' | 'nmi' | 'ft' | 's' | 'h' | 'day' | 'rad' | 'deg' | 'degC' | 'kn' | 'bar' | 'dbar'
  | 'V' | 'A' | 'J' | 'kJ' | 'MJ' | 'Ah' | '%' ;
COMPASS : 'N' | 'S' | 'E' | 'W' ;

// What the modem receives from other vehicles: `peer.top` from any, `ada.top` from `ada`.
HEARD : [A-Za-z_] [A-Za-z_0-9]* '.' [A-Za-z_] [A-Za-z_0-9]* ;
NAME : [A-Za-z_] [A-Za-z_0-9]* ;
// A time of the calendar, UTC: `2026-11-25T12:00Z`. Whether there is such a day is checked later.
INSTANT : [0-9] [0-9] [0-9] [0-9] '-' [0-9] [0-9] '-' [0-9] [0-9] 'T' [0-9] [0-9] ':' [0-9] [0-9] (':' [0-9] [0-9])? 'Z' ;
NUMBER : ([0-9]+ ('.' [0-9]+)? | '.' [0-9]+) ([eE] [+\-]? [0-9]+)? ;
STRING : '"' (~["\\\r\n] | '\\' ~[\r\n])* '"' ;

OR : '||' ;
AND : '&&' ;
NOT : '!' ;
EQ : '==' ;
NE : '!=' ;
LE : '<=' ;
GE : '>=' ;
LT : '<' ;
GT : '>' ;
PLUS : '+' ;
MINUS : '-' ;
TIMES : '*' ;
DIVIDE : '/' ;
ASSIGN : '=' ;
LPAREN : '(' ;
RPAREN : ')' ;
LBRACKET : '[' ;
RBRACKET : ']' ;
COMMA : ',' ;
COLON : ':' ;
RANGE : '..' ;

SPACE : [ \t\r\n\f]+ -> skip ;
LINE_COMMENT : ('#' | '//') ~[\r\n]* -> skip ;
BLOCK_COMMENT : '/*' .*? '*/' -> skip ;

// Mistakes.
ONE_AMPERSAND : '&' ;
ONE_BAR : '|' ;
WRONG_COMPARISON : '=>' | '=<' | '<>' | '===' | '!==' ;
SEMICOLON : ';' ;
OPEN_COMMENT : '/*' ;
OPEN_STRING : '"' (~["\\\r\n] | '\\' ~[\r\n])* ;
FOREIGN : [\u0080-\u00FF]+ | . ;
