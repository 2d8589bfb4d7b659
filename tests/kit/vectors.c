/* SPDX-FileCopyrightText: 2026 The glidercc authors */
/* SPDX-License-Identifier: Apache-2.0 */

/* Whether a build of the vehicle's side of the hooks answers as it must: check values, frames,
   messages, numbers, hookprog with an SBC, second by second, and hookbeh, cycle by cycle
   (hookbeh_vectors.c). Needs C99 and stdio.h, and no vehicle. Prints a line for each group, and
   each difference; ends with 1 if there is any.
   vectors.def has what is asked and what must come, from tests/kit/make_vectors. */
#include "tests/kit/vectors.h"

#include "hooks/hookprog/hookprog.h"
#include "hooks/protocol/bytes.h"
#include "hooks/protocol/crc.h"
#include "hooks/protocol/instruction.h"

#include <stdio.h>
#include <string.h>

typedef struct CrcVector {
  Span given;
  uint16_t crc16;
  uint32_t crc32c;
} CrcVector;
typedef struct FrameVector {
  uint8_t type, sequence;
  Span payload, line;
} FrameVector;
typedef struct LineVector {
  Span line;
  uint32_t frames, bad, doubles;
} LineVector;
typedef struct BeaconVector {
  uint8_t version;
  uint16_t offers, needs;
  uint32_t dictionary;
  uint8_t state;
  Span payload;
} BeaconVector;
typedef struct WelcomeVector {
  uint8_t virtual_time;
  uint32_t link, newest;
  Span payload;
} WelcomeVector;
typedef struct HelloVector {
  uint8_t version;
  uint16_t offers, needs;
  uint32_t dictionary, link;
  const char* name;
  Span payload;
} HelloVector;
typedef struct TransitionVector {
  uint64_t time;
  uint8_t transition;
  uint32_t from, to, fired_case;
  uint8_t list;
  Span payload;
} TransitionVector;
typedef struct DoneVector {
  uint8_t answered;
  uint32_t session;
  uint64_t time;
  uint32_t state;
  uint8_t stack_depth, phase;
  Span payload;
} DoneVector;
typedef struct NoteVector {
  uint64_t time;
  uint8_t kind;
  const char* text;
  Span payload;
} NoteVector;
typedef struct RefusedVector {
  uint8_t type;
  Span payload;
} RefusedVector;
typedef struct ValueVector {
  uint32_t width;
  uint64_t value, wire, again;
} ValueVector;
typedef struct InstructionVector {
  uint32_t session;
  uint16_t sequence;
  uint8_t control, vertical, lateral;
  uint64_t depth, depth_carried, pitch, pitch_carried, heading, heading_carried;
  uint64_t latitude, latitude_carried, longitude, longitude_carried;
  uint32_t sampling, check;
} InstructionVector;
typedef struct Update {
  uint16_t sensor;
  uint64_t value;
} Update;
typedef struct EventVector {
  uint8_t kind;
  uint64_t time;
  uint32_t a, b, c, d, e;
  const char* text;
} EventVector;
typedef struct Second {
  uint64_t time;
  Span updates, sets, received, sent, events;
} Second;
typedef struct Session {
  const char* name;
  bool virtual_time;
  uint32_t room; /* bytes that the line takes in a second */
  Span seconds;
} Session;

#include "tests/kit/vectors.def"

static uint32_t differences;

void want(bool holds, const char* group, const char* what, uint32_t vector) {
  if (!holds) {
    ++differences;
    printf("DIFFERENT: %s, %s, vector %lu\n", group, what, (unsigned long)vector);
  }
}

uint32_t differencesSoFar(void) {
  return differences;
}

void report(const char* group, uint32_t vectors, uint32_t before) {
  printf("%s: %lu vectors, %lu differences\n", group, (unsigned long)vectors,
         (unsigned long)(differences - before));
}

static const uint8_t* bytesOf(Span span) {
  return kPool + span.first;
}

static bool isSame(const uint8_t* bytes, uint32_t count, Span wanted) {
  return count == wanted.count && memcmp(bytes, bytesOf(wanted), count) == 0;
}

static bool hasBits(double value, uint64_t bits) {
  return hookBitsOfDouble(value) == bits;
}

static void checkCrcs(void) {
  const uint32_t before = differences;
  for (uint32_t i = 0; i < COUNT_OF(kCrcVectors); ++i) {
    const CrcVector* vector = &kCrcVectors[i];
    const uint8_t* bytes = bytesOf(vector->given);
    const uint32_t half = vector->given.count / 2;
    const uint32_t rest = vector->given.count - half;
    const uint16_t crc16 = hookCrc16(bytes, half, kHookCrc16Start);
    const uint32_t crc32c = hookCrc32c(bytes, half, kHookCrc32cStart);
    want(hookCrc16(bytes + half, rest, crc16) == vector->crc16, "check values", "CRC-16", i);
    want(hookCrc32c(bytes + half, rest, crc32c) == vector->crc32c, "check values", "CRC-32C", i);
  }
  report("check values", COUNT_OF(kCrcVectors), before);
}

/* A frame with this type and payload. */
static void fillFrame(HookFrame* frame, uint8_t type, uint8_t sequence, Span payload) {
  frame->type = type;
  frame->sequence = sequence;
  frame->size = (uint16_t)payload.count;
  memcpy(frame->payload, bytesOf(payload), payload.count);
}

static void checkFrames(void) {
  const uint32_t before = differences;
  static uint8_t line[kHookMostEncodedBytes];
  static HookFrameDecoder decoder;
  for (uint32_t i = 0; i < COUNT_OF(kFrameVectors); ++i) {
    const FrameVector* vector = &kFrameVectors[i];
    HookFrame frame;
    fillFrame(&frame, vector->type, vector->sequence, vector->payload);
    want(isSame(line, hookEncodeFrame(&frame, line), vector->line), "frames", "written", i);
    bool whole = false;
    for (uint32_t at = 0; at < vector->line.count; ++at) {
      whole = hookFrameDecoderPush(&decoder, bytesOf(vector->line)[at]);
    }
    want(whole && decoder.frame.type == vector->type &&
             decoder.frame.sequence == vector->sequence &&
             isSame(decoder.frame.payload, decoder.frame.size, vector->payload),
         "frames", "read", i);
  }
  report("frames", COUNT_OF(kFrameVectors), before);
}

static void checkLines(void) {
  const uint32_t before = differences;
  for (uint32_t i = 0; i < COUNT_OF(kLineVectors); ++i) {
    const LineVector* vector = &kLineVectors[i];
    static HookFrameDecoder decoder;
    memset(&decoder, 0, sizeof decoder);
    uint32_t frames = 0;
    for (uint32_t at = 0; at < vector->line.count; ++at) {
      frames += hookFrameDecoderPush(&decoder, bytesOf(vector->line)[at]) ? 1U : 0U;
    }
    want(frames == vector->frames, "damaged lines", "good frames", i);
    want(decoder.bad_frames == vector->bad, "damaged lines", "bad frames", i);
    want(decoder.doubles == vector->doubles, "damaged lines", "repeated frames", i);
  }
  report("damaged lines", COUNT_OF(kLineVectors), before);
}

static void checkBeacons(void) {
  for (uint32_t i = 0; i < COUNT_OF(kBeaconVectors); ++i) {
    const BeaconVector* vector = &kBeaconVectors[i];
    const HookBeacon beacon = {
        vector->version, {vector->offers, vector->needs}, vector->dictionary, vector->state};
    HookFrame frame;
    hookEncodeBeacon(&beacon, &frame);
    want(frame.type == kHookMessageTypeBeacon && isSame(frame.payload, frame.size, vector->payload),
         "messages", "Beacon written", i);
    HookBeacon read;
    want(hookDecodeBeacon(&frame, &read) && read.features.offers == vector->offers &&
             read.features.needs == vector->needs && read.dictionary == vector->dictionary &&
             read.hook_state == vector->state,
         "messages", "Beacon read", i);
  }
}

static void checkWelcomes(void) {
  for (uint32_t i = 0; i < COUNT_OF(kWelcomeVectors); ++i) {
    const WelcomeVector* vector = &kWelcomeVectors[i];
    const HookWelcome welcome = {vector->virtual_time != 0, vector->link, vector->newest};
    HookFrame frame;
    hookEncodeWelcome(&welcome, &frame);
    want(
        frame.type == kHookMessageTypeWelcome && isSame(frame.payload, frame.size, vector->payload),
        "messages", "Welcome written", i);
  }
}

static void checkHellos(void) {
  for (uint32_t i = 0; i < COUNT_OF(kHelloVectors); ++i) {
    const HelloVector* vector = &kHelloVectors[i];
    HookFrame frame;
    fillFrame(&frame, kHookMessageTypeHello, 1, vector->payload);
    HookHello hello;
    want(hookDecodeHello(&frame, &hello) && hello.version == vector->version &&
             hello.features.offers == vector->offers && hello.features.needs == vector->needs &&
             hello.dictionary == vector->dictionary && hello.link == vector->link &&
             strcmp(hello.mission_name, vector->name) == 0,
         "messages", "Hello read", i);
  }
}

static void checkTransitions(void) {
  for (uint32_t i = 0; i < COUNT_OF(kTransitionVectors); ++i) {
    const TransitionVector* vector = &kTransitionVectors[i];
    HookFrame frame;
    fillFrame(&frame, kHookMessageTypeTransition, 1, vector->payload);
    HookTransitionNotice notice;
    want(hookDecodeTransition(&frame, &notice) && hasBits(notice.mission_time_s, vector->time) &&
             notice.transition == vector->transition && notice.from == vector->from &&
             notice.to == vector->to && notice.fired_case == vector->fired_case &&
             notice.list == vector->list,
         "messages", "Transition read", i);
  }
}

static void checkDones(void) {
  for (uint32_t i = 0; i < COUNT_OF(kDoneVectors); ++i) {
    const DoneVector* vector = &kDoneVectors[i];
    HookFrame frame;
    fillFrame(&frame, kHookMessageTypeDone, 1, vector->payload);
    HookDone done;
    want(hookDecodeDone(&frame, &done) && done.answered == vector->answered &&
             done.session == vector->session && hasBits(done.status.mission_time_s, vector->time) &&
             done.status.state == vector->state && done.status.stack_depth == vector->stack_depth &&
             done.status.phase == vector->phase,
         "messages", "Done read", i);
  }
}

static void checkNotes(void) {
  for (uint32_t i = 0; i < COUNT_OF(kNoteVectors); ++i) {
    const NoteVector* vector = &kNoteVectors[i];
    HookFrame frame;
    fillFrame(&frame, kHookMessageTypeNote, 1, vector->payload);
    HookMissionNote note;
    want(hookDecodeNote(&frame, &note) && hasBits(note.mission_time_s, vector->time) &&
             note.kind == vector->kind && strcmp(note.text, vector->text) == 0,
         "messages", "Note read", i);
  }
}

static const GliderDictionary kDictionary = {kSensors, kRoles, kSensorCount, kDictionaryHash};

/* Whether any message that the vehicle reads is in the frame. */
static bool isRead(const HookFrame* frame) {
  HookHello hello;
  HookTransitionNotice notice;
  HookDone done;
  HookMissionNote note;
  HookSubscribe subscribe;
  HookSensorList list;
  HookNap nap;
  HookSubscribe subscription;
  memset(&subscription, 0, sizeof subscription);
  subscription.count = 1;
  subscription.sensors[0].id = 2;
  return hookDecodeHello(frame, &hello) || hookDecodeTransition(frame, &notice) ||
         hookDecodeDone(frame, &done) || hookDecodeNote(frame, &note) ||
         hookDecodeSubscribe(&kDictionary, frame, &subscribe) ||
         hookDecodeList(&kDictionary, frame, &list) || hookDecodeNap(frame, &subscription, &nap);
}

static void checkMessages(void) {
  const uint32_t before = differences;
  checkBeacons();
  checkWelcomes();
  checkHellos();
  checkTransitions();
  checkDones();
  checkNotes();
  for (uint32_t i = 0; i < COUNT_OF(kRefusedVectors); ++i) {
    HookFrame frame;
    fillFrame(&frame, kRefusedVectors[i].type, 1, kRefusedVectors[i].payload);
    want(!isRead(&frame), "messages", "refused", i);
  }
  report("messages",
         COUNT_OF(kBeaconVectors) + COUNT_OF(kWelcomeVectors) + COUNT_OF(kHelloVectors) +
             COUNT_OF(kTransitionVectors) + COUNT_OF(kDoneVectors) + COUNT_OF(kNoteVectors) +
             COUNT_OF(kRefusedVectors),
         before);
}

static void checkValues(void) {
  const uint32_t before = differences;
  for (uint32_t i = 0; i < COUNT_OF(kValueVectors); ++i) {
    const ValueVector* vector = &kValueVectors[i];
    want(hookToWire(vector->width, hookDoubleOf(vector->value)) == vector->wire, "values",
         "to the line", i);
    want(hasBits(hookFromWire(vector->width, vector->wire), vector->again), "values",
         "from the line", i);
  }
  report("values", COUNT_OF(kValueVectors), before);
}

static void fillInstruction(const InstructionVector* vector, HookInstruction* instruction) {
  instruction->session = vector->session;
  instruction->sequence = vector->sequence;
  instruction->control = vector->control;
  instruction->vertical = vector->vertical;
  instruction->lateral = vector->lateral;
  instruction->depth_m = hookDoubleOf(vector->depth);
  instruction->pitch_rad = hookDoubleOf(vector->pitch);
  instruction->heading_rad = hookDoubleOf(vector->heading);
  instruction->latitude_ddmm = hookDoubleOf(vector->latitude);
  instruction->longitude_ddmm = hookDoubleOf(vector->longitude);
  instruction->sampling = vector->sampling;
}

static bool isCarried(const HookInstruction* instruction, const InstructionVector* vector) {
  return instruction->session == vector->session && instruction->sequence == vector->sequence &&
         instruction->control == vector->control && instruction->vertical == vector->vertical &&
         instruction->lateral == vector->lateral &&
         hasBits(instruction->depth_m, vector->depth_carried) &&
         hasBits(instruction->pitch_rad, vector->pitch_carried) &&
         hasBits(instruction->heading_rad, vector->heading_carried) &&
         hasBits(instruction->latitude_ddmm, vector->latitude_carried) &&
         hasBits(instruction->longitude_ddmm, vector->longitude_carried) &&
         instruction->sampling == vector->sampling;
}

static void checkInstructions(void) {
  const uint32_t before = differences;
  for (uint32_t i = 0; i < COUNT_OF(kInstructionVectors); ++i) {
    const InstructionVector* vector = &kInstructionVectors[i];
    HookInstruction given;
    HookInstruction read;
    HookInstructionWords words;
    fillInstruction(vector, &given);
    want(hookCheckValue(&given) == vector->check, "instructions", "check value", i);
    hookWordsOf(&given, &words);
    want(hookInstructionOf(&words, &read) && isCarried(&read, vector), "instructions", "read", i);
    words.check += 1;
    want(!hookInstructionOf(&words, &read), "instructions", "another check value", i);
  }
  report("instructions", COUNT_OF(kInstructionVectors), before);
}

/* The data memory of a science computer, and its line to an SBC, in one second. */
typedef struct Bench {
  double values[kSensorCount];
  bool fresh[kSensorCount];
  Span received;      /* what the SBC has sent and hookprog has not read */
  uint8_t sent[2048]; /* by hookprog */
  uint32_t sent_count, room;
  HookSensorValue sets[64]; /* by hookprog, in order */
  uint32_t set_count;
} Bench;

static double getValue(void* self, uint16_t id, bool* fresh) {
  Bench* bench = self;
  *fresh = bench->fresh[id];
  bench->fresh[id] = false;
  return bench->values[id];
}

static void setValue(void* self, uint16_t id, double value) {
  Bench* bench = self;
  if (bench->set_count < COUNT_OF(bench->sets)) {
    bench->sets[bench->set_count].id = id;
    bench->sets[bench->set_count].value = value;
  }
  ++bench->set_count;
}

static int32_t readLine(void* self, uint8_t* bytes, uint32_t capacity) {
  Bench* bench = self;
  const uint32_t count = bench->received.count < capacity ? bench->received.count : capacity;
  memcpy(bytes, bytesOf(bench->received), count);
  bench->received.first += count;
  bench->received.count -= count;
  return (int32_t)count;
}

static int32_t writeLine(void* self, const uint8_t* bytes, uint32_t count) {
  Bench* bench = self;
  const uint32_t room = bench->room - bench->sent_count;
  const uint32_t taken = count < room ? count : room;
  memcpy(bench->sent + bench->sent_count, bytes, taken);
  bench->sent_count += taken;
  return (int32_t)taken;
}

static void runSecond(Hookprog* hookprog, Bench* bench, const Second* second) {
  for (uint32_t i = 0; i < second->updates.count; ++i) {
    const Update* update = &kUpdates[second->updates.first + i];
    bench->values[update->sensor] = hookDoubleOf(update->value);
    bench->fresh[update->sensor] = true;
  }
  bench->received = second->received;
  bench->sent_count = 0;
  bench->set_count = 0;
  const HookScienceMemory memory = {bench, getValue, setValue};
  const GliderByteStream line = {bench, readLine, writeLine};
  hookprogRun(hookprog, hookDoubleOf(second->time), &memory, &line);
}

static bool isEvent(const HookSeatEvent* event, const EventVector* wanted) {
  return event->kind == wanted->kind && hasBits(event->mission_time_s, wanted->time) &&
         event->a == wanted->a && event->b == wanted->b && event->c == wanted->c &&
         event->d == wanted->d && event->e == wanted->e && strcmp(event->text, wanted->text) == 0;
}

static void checkSecond(Hookprog* hookprog, const Bench* bench, const Second* second,
                        const char* name, uint32_t number) {
  want(isSame(bench->sent, bench->sent_count, second->sent), name, "sent to the SBC in second",
       number);
  want(bench->set_count == second->sets.count, name, "sensors set in second", number);
  for (uint32_t i = 0; i < bench->set_count && i < second->sets.count; ++i) {
    const Update* wanted = &kSets[second->sets.first + i];
    want(bench->sets[i].id == wanted->sensor && hasBits(bench->sets[i].value, wanted->value), name,
         "a sensor set in second", number);
  }
  HookSeatEvent event;
  for (uint32_t i = 0; i < second->events.count; ++i) {
    want(hookprogNextEvent(hookprog, &event) && isEvent(&event, &kEvents[second->events.first + i]),
         name, "an event in second", number);
  }
  want(!hookprogNextEvent(hookprog, &event), name, "no more events in second", number);
}

static void checkSession(const Session* session) {
  const uint32_t before = differences;
  static Hookprog hookprog;
  static Bench bench;
  memset(&bench, 0, sizeof bench);
  bench.room = session->room;
  for (uint32_t id = 0; id < kSensorCount; ++id) {
    bench.values[id] = hookDoubleOf(UINT64_C(0x7FF8000000000000));
  }
  const HookSeatOptions options = {session->virtual_time, 0};
  hookprogInit(&hookprog, &kDictionary, &options);
  for (uint32_t i = 0; i < session->seconds.count; ++i) {
    const Second* second = &kSeconds[session->seconds.first + i];
    runSecond(&hookprog, &bench, second);
    checkSecond(&hookprog, &bench, second, session->name, i);
  }
  report(session->name, session->seconds.count, before);
}

int main(void) {
  checkCrcs();
  checkFrames();
  checkLines();
  checkMessages();
  checkValues();
  checkInstructions();
  for (uint32_t i = 0; i < COUNT_OF(kSessions); ++i) {
    checkSession(&kSessions[i]);
  }
  checkHookbeh();
  if (differences != 0) {
    printf("This build differs in %lu places.\n", (unsigned long)differences);
    return 1;
  }
  printf("This build answers as it must.\n");
  return 0;
}
