/* SPDX-FileCopyrightText: 2026 The glidercc authors */
/* SPDX-License-Identifier: Apache-2.0 */

#ifndef GLIDER_TESTS_KIT_VECTORS_H
#define GLIDER_TESTS_KIT_VECTORS_H

#include <stdbool.h>
#include <stdint.h>

/* What the groups of vectors share. */
typedef struct Span {
  uint32_t first, count;
} Span;

#define COUNT_OF(array) ((uint32_t)(sizeof(array) / sizeof((array)[0])))

/* Counts and prints a difference unless `holds`. */
void want(bool holds, const char* group, const char* what, uint32_t vector);
/* How many differences there are so far. */
uint32_t differencesSoFar(void);
/* Prints the line of a group with so many vectors, from the number of differences before it. */
void report(const char* group, uint32_t vectors, uint32_t before);

/* The flights of hookbeh. */
void checkHookbeh(void);

#endif
