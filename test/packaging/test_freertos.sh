#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The example for FreeRTOS, built and run with a stand-in for the few calls it makes: tasks are POSIX threads, and the camera
# and the held frame a made-up scene. FreeRTOS is in no package: its own kernel is not built.
. "$(dirname "$0")/common.sh"
cat >"$work/FreeRTOS.h" <<'END'
#include <pthread.h>
#include <stdint.h>
#include <stdlib.h>
#include "FreeRTOSConfig.h"
typedef unsigned long UBaseType_t;
typedef uint32_t StackType_t, TickType_t, configSTACK_DEPTH_TYPE;
typedef struct { pthread_t thread; } StaticTask_t;
typedef void (*TaskFunction_t)(void *);
typedef struct { pthread_mutex_t lock; pthread_cond_t moved; uint8_t *rows; size_t size, count, held, first; } StaticQueue_t;
typedef StaticQueue_t *QueueHandle_t;
#define portMAX_DELAY 0xffffffffu
#define configASSERT(x) do { if (!(x)) abort(); } while (0)
static pthread_mutex_t critical = PTHREAD_MUTEX_INITIALIZER;
#define taskENTER_CRITICAL() pthread_mutex_lock(&critical)
#define taskEXIT_CRITICAL()  pthread_mutex_unlock(&critical)
END
cat >"$work/queue.h" <<'END'
#include <string.h>
static QueueHandle_t xQueueCreateStatic(UBaseType_t count, UBaseType_t size, uint8_t *rows, StaticQueue_t *q)
{
    const StaticQueue_t fresh = {PTHREAD_MUTEX_INITIALIZER, PTHREAD_COND_INITIALIZER, rows, size, count, 0, 0};
    *q = fresh;
    return q;
}
static void xQueueSend(QueueHandle_t q, const void *row, TickType_t ticks)
{
    (void)ticks;
    pthread_mutex_lock(&q->lock);
    while (q->held == q->count)
        pthread_cond_wait(&q->moved, &q->lock);
    memcpy(q->rows + (q->first + q->held++) % q->count * q->size, row, q->size);
    pthread_cond_broadcast(&q->moved);
    pthread_mutex_unlock(&q->lock);
}
static void xQueueReceive(QueueHandle_t q, void *row, TickType_t ticks)
{
    (void)ticks;
    pthread_mutex_lock(&q->lock);
    while (q->held == 0)
        pthread_cond_wait(&q->moved, &q->lock);
    memcpy(row, q->rows + q->first * q->size, q->size);
    q->first = (q->first + 1) % q->count;
    q->held--;
    pthread_cond_broadcast(&q->moved);
    pthread_mutex_unlock(&q->lock);
}
END
cat >"$work/task.h" <<'END'
#include <unistd.h>
typedef struct { TaskFunction_t run; } begin;
static void *begin_task(void *run) { ((begin *)run)->run(NULL); return NULL; }
static void xTaskCreateStatic(TaskFunction_t run, const char *name, uint32_t words, void *job, UBaseType_t priority,
                              StackType_t *stack, StaticTask_t *task)
{
    begin *b = malloc(sizeof *b);
    (void)name, (void)words, (void)job, (void)priority, (void)stack;
    b->run = run;
    if (pthread_create(&task->thread, NULL, begin_task, b) != 0)
        abort();
}
static void vTaskStartScheduler(void) { for (;;) pause(); }
static void vTaskDelay(TickType_t ticks) { (void)ticks; pause(); }
END
cat >"$work/board.c" <<'END'
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include "scene.h"
#include "stad/stad.h"
enum { FRAMES = 3 };
static const scene live = {160, 120, 32, 3, 20}, kept = {160, 120, 32, 12, 7};
static atomic_int frames, searched;
static int valid;
void camera_wait_row(int y, uint8_t *left, uint8_t *right);
void held_row(int y, uint8_t *left, uint8_t *right, int32_t *truth_q16, uint8_t *label);
void disparity_row(int y, const int16_t *disp_q4);
void camera_wait_row(int y, uint8_t *left, uint8_t *right) { scene_row(&live, y, left, right, NULL); }
void held_row(int y, uint8_t *left, uint8_t *right, int32_t *truth_q16, uint8_t *label)
{
    int32_t scratch[160];
    scene_row(&kept, y, left, right, truth_q16);
    stad_score_label_row(truth_q16, 160, label, scratch);
    searched += y == 119;
}
void disparity_row(int y, const int16_t *disp_q4)
{
    for (int x = 32; x < 160; x++)
        valid += disp_q4[x] >= 0;
    if (y == 119 && ++frames >= FRAMES && searched > 8) { /* asked twice an evaluation */
        printf("%d frames of 128 x 120 px, %d with a disparity; %d evaluations\n", frames, valid / frames, searched / 2);
        exit(valid / frames > 128 * 120 / 2 ? 0 : 1);
    }
}
END
quietly "$cc" -std=c11 -D_POSIX_C_SOURCE=200809L -Wall -Wextra -Werror -O1 -pthread -I"$work" -I"$source_dir/examples/freertos" -I"$source_dir/examples/mcu" \
    -I"$source_dir/lib/include" -I"$source_dir/lib/src" -I"$source_dir/port/isa/c" "$source_dir"/lib/src/*/*.c \
    "$source_dir/examples/freertos/main.c" "$source_dir/examples/mcu/scene.c" "$work/board.c" -o "$work/firmware"
quietly timeout 120 "$work/firmware"
cat "$work/log"
