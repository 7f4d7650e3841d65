/* SPDX-License-Identifier: MIT
 * stad/main.c - the command-line tool: finds the command and runs it. */
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "stad/config.h"
#include "tool.h"

typedef struct command {
    const char *name;
    int (*run)(int argc, char **argv);
    const char *what;
} command;

static const command commands[] = {
    {"match", cmd_match, "disparity of a rectified pair, bit for bit cv::StereoSGBM"},
    {"eval", cmd_eval, "a disparity map against ground truth"},
    {"tune", cmd_tune, "better parameters for pairs with ground truth"},
    {"simulate", cmd_simulate, "recorded frames through the code that a board runs"},
    {"plan", cmd_plan, "bytes of memory, by mode, plan and part"},
    {"bench", cmd_bench, "time per pixel and disparity"},
    {"scene", cmd_scene, "draws a stereo pair with exact truth"},
    {"sheet", cmd_sheet, "the printable calibration target, PDF or SVG"},
};

#define COMMANDS (sizeof commands / sizeof commands[0])

static int usage(FILE *to)
{
    fprintf(to, "usage: stad COMMAND ...\n\n");
    for (size_t i = 0; i < COMMANDS; i++)
        fprintf(to, "  %-8s %s\n", commands[i].name, commands[i].what);
    fprintf(to, "\n`stad COMMAND --help` tells more; `stad --version` which version this is.\n"
                "Exit status: 0 done; 1 a comparison failed; 2 bad usage or parameter; 3 a file cannot be "
                "read or written.\n");
    return to == stdout ? TOOL_OK : TOOL_USAGE;
}

static int run(const command *c, int argc, char **argv)
{
    char name[32];
    snprintf(name, sizeof name, "stad %s", c->name);
    argv[0] = name;
    return c->run(argc, argv);
}

static int dispatch(int argc, char **argv)
{
    if (argc < 2)
        return usage(stderr);
    if (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0)
        return usage(stdout);
    if (strcmp(argv[1], "--version") == 0) {
        puts("stad " STAD_VERSION);
        return TOOL_OK;
    }
    for (size_t i = 0; i < COMMANDS; i++)
        if (strcmp(argv[1], commands[i].name) == 0)
            return run(&commands[i], argc - 1, argv + 1);
    fprintf(stderr, "stad: no command \"%s\"\n", argv[1]);
    return usage(stderr);
}

/* A standard stream that is closed would lend its number to the first file opened. What holds its place instead refuses what the
 * stream is for, so that only what is really printed can be lost. */
static void hold_standard_streams(void)
{
    for (int fd = STDIN_FILENO; fd <= STDERR_FILENO; fd++)
        if (fcntl(fd, F_GETFD) == -1)
            (void)!open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

int main(int argc, char **argv)
{
    hold_standard_streams();
    int status = dispatch(argc, argv);
    int lost = ferror(stdout);
    lost |= fclose(stdout) != 0;
    if (lost && status == TOOL_OK) {
        fputs("stad: the output could not be written\n", stderr);
        return TOOL_FILE;
    }
    return status;
}
