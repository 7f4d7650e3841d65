/* SPDX-License-Identifier: MIT
 * tools/count/count.c - a QEMU plugin that counts executed instructions by function, between marks of the firmware.
 *
 * Entering a function count_begin_<name> starts the region <name>, entering count_end closes it. At exit a line
 * `<name>,<function>,<instructions>` is printed for every region and function that ran in it, most first; regions in order.
 * One processor and no interrupts: the same image gives the same digits every time. Debian's QEMU 7.2 takes plugins but
 * ships no header, so the few calls that are used are declared here, as version 1 of the interface documents them. */
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define EXPORT __attribute__((visibility("default")))

typedef uint64_t plugin_id;
struct plugin_tb;
struct plugin_insn;
enum { INLINE_ADD_U64 = 0, NO_REGISTERS = 0, INTERFACE_VERSION = 1 };

extern void qemu_plugin_register_vcpu_tb_trans_cb(plugin_id id, void (*call)(plugin_id id, struct plugin_tb *tb));
extern void qemu_plugin_register_atexit_cb(plugin_id id, void (*call)(plugin_id id, void *data), void *data);
extern void qemu_plugin_register_vcpu_insn_exec_inline(struct plugin_insn *insn, int op, void *counter, uint64_t by);
extern void qemu_plugin_register_vcpu_insn_exec_cb(struct plugin_insn *insn, void (*call)(unsigned vcpu, void *data),
                                                   int registers, void *data);
extern size_t qemu_plugin_tb_n_insns(const struct plugin_tb *tb);
extern struct plugin_insn *qemu_plugin_tb_get_insn(const struct plugin_tb *tb, size_t i);
extern const char *qemu_plugin_insn_symbol(const struct plugin_insn *insn);
extern void qemu_plugin_outs(const char *text);

EXPORT extern int qemu_plugin_version;
EXPORT int qemu_plugin_install(plugin_id id, const void *info, int argc, char **argv);
int qemu_plugin_version = INTERFACE_VERSION;

enum { FUNCTIONS = 4096, REGIONS = 64 };

struct function {
    char *name;
    uint64_t count, start; /* instructions so far; at the start of the open region */
};

static struct function functions[FUNCTIONS];
static size_t function_count;
static struct region {
    const char *name;
    uint64_t count[FUNCTIONS];
} regions[REGIONS];
static size_t region_count;
static const char *open_region;

static struct function *function_named(const char *name)
{
    size_t i;
    for (i = 0; i < function_count; i++)
        if (strcmp(functions[i].name, name) == 0)
            return &functions[i];
    if (function_count == FUNCTIONS)
        abort();
    functions[function_count].name = strdup(name);
    return &functions[function_count++];
}

/* Runs at every instruction of a mark, so the last one decides: what is counted starts after the mark. */
static void begin_region(unsigned vcpu, void *data)
{
    size_t i;
    (void)vcpu;
    open_region = data;
    for (i = 0; i < function_count; i++)
        functions[i].start = functions[i].count;
}

static void end_region(unsigned vcpu, void *data)
{
    size_t i;
    (void)vcpu;
    (void)data;
    if (open_region == NULL)
        return;
    if (region_count == REGIONS)
        abort();
    regions[region_count].name = open_region;
    for (i = 0; i < function_count; i++)
        regions[region_count].count[i] = functions[i].count - functions[i].start;
    region_count++;
    open_region = NULL;
}

static void translated(plugin_id id, struct plugin_tb *tb)
{
    static const char begin[] = "count_begin_";
    const size_t n = qemu_plugin_tb_n_insns(tb);
    size_t i;
    (void)id;
    for (i = 0; i < n; i++) {
        struct plugin_insn *insn = qemu_plugin_tb_get_insn(tb, i);
        const char *symbol = qemu_plugin_insn_symbol(insn);
        struct function *f = function_named(symbol != NULL && symbol[0] != '\0' ? symbol : "?");
        if (strncmp(f->name, begin, sizeof begin - 1) == 0)
            qemu_plugin_register_vcpu_insn_exec_cb(insn, begin_region, NO_REGISTERS, f->name + sizeof begin - 1);
        else if (strcmp(f->name, "count_end") == 0)
            qemu_plugin_register_vcpu_insn_exec_cb(insn, end_region, NO_REGISTERS, NULL);
        else
            qemu_plugin_register_vcpu_insn_exec_inline(insn, INLINE_ADD_U64, &f->count, 1);
    }
}

static const struct region *sorting;

static int most_first(const void *a, const void *b)
{
    const size_t i = *(const size_t *)a, j = *(const size_t *)b;
    if (sorting->count[i] != sorting->count[j])
        return sorting->count[i] < sorting->count[j] ? 1 : -1;
    return strcmp(functions[i].name, functions[j].name);
}

static void report(plugin_id id, void *data)
{
    static size_t order[FUNCTIONS];
    char line[512];
    size_t r, i;
    (void)id;
    (void)data;
    for (r = 0; r < region_count; r++) {
        for (i = 0; i < function_count; i++)
            order[i] = i;
        sorting = &regions[r];
        qsort(order, function_count, sizeof order[0], most_first);
        for (i = 0; i < function_count && regions[r].count[order[i]] > 0; i++) {
            snprintf(line, sizeof line, "count:%s,%s,%llu\n", regions[r].name, functions[order[i]].name,
                     (unsigned long long)regions[r].count[order[i]]);
            qemu_plugin_outs(line);
        }
    }
}

int qemu_plugin_install(plugin_id id, const void *info, int argc, char **argv)
{
    (void)info;
    (void)argc;
    (void)argv;
    qemu_plugin_register_vcpu_tb_trans_cb(id, translated);
    qemu_plugin_register_atexit_cb(id, report, NULL);
    return 0;
}
