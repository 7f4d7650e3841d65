/* SPDX-License-Identifier: MIT
 * examples/freertos/main.c - camera rows -> [queue] -> matcher task -> disparity; a tuner task in whatever time is left
 *
 * Three tasks, nothing allocated. The camera task hands rows over as they come; the matcher task turns them into
 * disparities; the tuner, lowest of all, matches a held crop with the point it asks for and tells the cost: it has a matcher
 * and a workspace of its own, so nothing is shared but the parameters, which the matcher task copies at the start of a frame.
 * The camera and the truth of the held frame are the board's: replace the two functions at the top. */
#include <string.h>

#include "FreeRTOS.h"
#include "queue.h"
#include "task.h"

#include "stad/score.h"
#include "stad/stad.h"
#include "stad/tune.h"

enum { WIDTH = 160, HEIGHT = 120, DISPARITIES = 32, BLOCK = 5, P2 = 800, CAP = 63, QUEUE_ROWS = 4, STACK_WORDS = 512 };

/* -- the board's: a camera, and a held frame with its truth --------------------------------------------------------------- */

void camera_wait_row(int y, uint8_t *left, uint8_t *right);                              /* blocks until row y is in */
void held_row(int y, uint8_t *left, uint8_t *right, int32_t *truth_q16, uint8_t *label); /* of the tuning frame */
void disparity_row(int y, const int16_t *disp_q4);                                       /* takes what was made */

/* -- shared: the parameters in use ----------------------------------------------------------------------------------------- */

static stad_params in_use;

static stad_params params_now(void)
{
    stad_params p;
    taskENTER_CRITICAL();
    p = in_use;
    taskEXIT_CRITICAL();
    return p;
}

static void use(const stad_params *p)
{
    taskENTER_CRITICAL();
    in_use = *p;
    taskEXIT_CRITICAL();
}

/* -- camera and matcher ------------------------------------------------------------------------------------------------------ */

typedef struct row_pair {
    uint8_t left[WIDTH], right[WIDTH];
} row_pair;

static QueueHandle_t rows;

static void camera_task(void *unused)
{
    static row_pair row;
    int y;
    (void)unused;
    for (;;)
        for (y = 0; y < HEIGHT; y++) {
            camera_wait_row(y, row.left, row.right);
            xQueueSend(rows, &row, portMAX_DELAY);
        }
}

#define WORK_BYTES STAD_MATCH_BYTES(WIDTH, HEIGHT, 1, DISPARITIES, BLOCK, P2, CAP, STAD_MODE_SGBM, STAD_MEMORY_SMALL)
static const stad_geometry geometry = {WIDTH, HEIGHT, 1, DISPARITIES, BLOCK, P2, CAP, STAD_MODE_SGBM, STAD_MEMORY_SMALL};

static void matcher_task(void *unused)
{
    static STAD_ALIGNED uint8_t work[WORK_BYTES];
    static stad_match matcher;
    static row_pair row;
    static int16_t disp_q4[WIDTH];
    stad_params p;
    int y, made;
    (void)unused;
    configASSERT(stad_match_init(&matcher, &geometry, work, sizeof work) == STAD_OK);
    for (;;) {
        p = params_now();
        configASSERT(stad_match_begin(&matcher, &p) == STAD_OK);
        for (y = 0; y < HEIGHT; y++) {
            xQueueReceive(rows, &row, portMAX_DELAY);
            stad_match_push(&matcher, row.left, row.right);
            while ((made = stad_match_pull(&matcher, disp_q4)) >= 0)
                disparity_row(made, disp_q4);
        }
    }
}

/* -- tuner -------------------------------------------------------------------------------------------------------------------- */

static int32_t cost_of(stad_match *matcher, const stad_params *p)
{
    static row_pair row;
    static int16_t disp_q4[WIDTH];
    static int32_t truth_q16[WIDTH];
    static uint8_t label[WIDTH];
    stad_score_config config;
    stad_score score;
    int y, made;
    stad_score_config_init(&config, STAD_SCORE_CHOW, 0, DISPARITIES);
    if (stad_score_begin(&score, &config) != STAD_OK || stad_match_begin(matcher, p) != STAD_OK)
        return STAD_COST_FAILED;
    for (y = 0; y < HEIGHT; y++) {
        held_row(y, row.left, row.right, truth_q16, label);
        stad_match_push(matcher, row.left, row.right);
        while ((made = stad_match_pull(matcher, disp_q4)) >= 0) {
            held_row(made, row.left, row.right, truth_q16, label);
            stad_score_row(&score, made, disp_q4, truth_q16, label, WIDTH);
        }
    }
    return stad_score_end(&score);
}

static void apply(const stad_point *x, stad_params *p)
{
    p->p1 = x->v[STAD_TUNE_P1];
    p->p2 = x->v[STAD_TUNE_P2];
    p->block_size = x->v[STAD_TUNE_BLOCK_SIZE];
    p->uniqueness_ratio = x->v[STAD_TUNE_UNIQUENESS_RATIO];
    p->pre_filter_cap = x->v[STAD_TUNE_PRE_FILTER_CAP];
    p->disp12_max_diff = x->v[STAD_TUNE_DISP12_MAX_DIFF];
}

static void tuner_task(void *unused)
{
    static STAD_ALIGNED uint8_t work[WORK_BYTES];
    static stad_match matcher;
    static stad_tune tune;
    static const stad_point first = {{200, 800, 5, 10, 63, 1}};
    stad_tune_config config;
    stad_params p = params_now();
    stad_point x;
    (void)unused;
    stad_tune_config_stereo(&config, STAD_TUNE_FOR_ANY);
    config.axis[STAD_TUNE_P1].hi = P2 / 2;
    config.axis[STAD_TUNE_P2].hi = P2;
    config.axis[STAD_TUNE_BLOCK_SIZE].hi = BLOCK;
    config.axis[STAD_TUNE_PRE_FILTER_CAP].hi = CAP;
    configASSERT(stad_match_init(&matcher, &geometry, work, sizeof work) == STAD_OK);
    configASSERT(stad_tune_ncg_init(&tune, &config, &first) == STAD_OK);
    while (stad_tune_ask(&tune, &x) == 1) { /* one evaluation a turn; everything else runs before it */
        apply(&x, &p);
        stad_tune_ncg_tell(&tune, cost_of(&matcher, &p));
    }
    if (stad_tune_best(&tune, &x, NULL) == STAD_OK) {
        apply(&x, &p);
        use(&p);
    }
    for (;;)
        vTaskDelay(portMAX_DELAY);
}

/* -- start -------------------------------------------------------------------------------------------------------------------- */

typedef struct task_memory {
    StaticTask_t task;
    StackType_t stack[STACK_WORDS];
} task_memory;

static void start(TaskFunction_t run, const char *name, UBaseType_t priority, task_memory *memory)
{
    xTaskCreateStatic(run, name, STACK_WORDS, NULL, priority, memory->stack, &memory->task);
}

int main(void)
{
    static StaticQueue_t queue;
    static uint8_t queue_rows[QUEUE_ROWS * sizeof(row_pair)];
    static task_memory camera, matcher, tuner;
    stad_params_sample(&in_use, DISPARITIES, BLOCK, 1);
    rows = xQueueCreateStatic(QUEUE_ROWS, sizeof(row_pair), queue_rows, &queue);
    start(camera_task, "camera", 3, &camera);
    start(matcher_task, "match", 2, &matcher);
    start(tuner_task, "tune", 1, &tuner);
    vTaskStartScheduler();
    return 1;
}

/* FreeRTOS asks for the idle task's memory. */
void vApplicationGetIdleTaskMemory(StaticTask_t **task, StackType_t **stack, configSTACK_DEPTH_TYPE *words);
void vApplicationGetIdleTaskMemory(StaticTask_t **task, StackType_t **stack, configSTACK_DEPTH_TYPE *words)
{
    static StaticTask_t idle;
    static StackType_t idle_stack[configMINIMAL_STACK_SIZE];
    *task = &idle;
    *stack = idle_stack;
    *words = configMINIMAL_STACK_SIZE;
}
