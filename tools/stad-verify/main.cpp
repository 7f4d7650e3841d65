// SPDX-License-Identifier: MIT
// stad-verify - holds the library bit for bit against cv::StereoSGBM.
#include <getopt.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>

#include "stad/match.h"
#include "stad/status.h"
#include "support/reference.h"
#include "verify.hpp"

static const char usage_text[] =
    "usage: stad-verify LEFT RIGHT [--mode sgbm|hh|3way|hh4|all] [--memory fast|small|both] [--color] [parameters of stad match]\n"
    "       stad-verify --random N [--seed S] [--mode ...] [--memory ...] [--stress | --ordinary]\n"
    "       stad-verify --width W --height H --channels C --scene KIND:SEED:X0:Y0:DMIN:DCOUNT [parameters]   (replays a case)\n"
    "       stad-verify --bench SECONDS [LEFT RIGHT, or a case] [--mode ...] [--memory ...] [parameters]   (VGA)\n"
    "       stad-verify --golden   (prints the table of test/golden)\n"
    "Compares the library, a frame at once and row by row in a random order, with OpenCV on one thread. A mismatch is shrunk;\n"
    "its parameters, the first differing pixel and both values are printed. Values that OpenCV repairs in silence are\n"
    "normalised first. --subject reference [--mend QUIRK] checks the specification's reference, or a broken one, instead.\n"
    "--bench times both in turn on one thread and prints how many times faster the library is: the median of the paired\n"
    "ratios of thread-CPU time, and its quartiles. STAD_ISA=c|sse41|avx2|avx512 in the environment lowers the tier.\n"
    "Exit status: 0 equal, 1 different, 2 bad usage, 3 a file cannot be read.\n";

struct Options {
    std::vector<int> modes{0};
    std::vector<int> memories{STAD_MEMORY_FAST, STAD_MEMORY_SMALL};
    std::vector<Subject> subjects{Subject::Frame, Subject::Rows};
    unsigned mends = 0;
    long random = -1;
    uint32_t seed = 1;
    int kinds = 2; // 0 ordinary, 1 stress, 2 in turns
    bool color = false, replay = false, golden = false, bench = false;
    double seconds = 2;
    test_case one{};
    std::vector<std::string> files;
};

struct Tally {
    long cases = 0, comparisons = 0, differing = 0;
};

void print_golden(); // golden.cpp

[[noreturn]] static void bad_usage(const std::string &what)
{
    std::fprintf(stderr, "stad-verify: %s\n%s", what.c_str(), usage_text);
    std::exit(2);
}

static void report(const test_case &c, const Verdict &v, const char *title)
{
    char text[600];
    case_text(&c, text, sizeof text);
    std::printf("  %s: stad-verify %s\n", title, text);
    if (!v.error.empty()) {
        std::printf("    no answer: %s\n", v.error.c_str());
    } else {
        std::printf("    first differing pixel x=%d y=%d: OpenCV %d, subject %d (%ld pixels differ)\n", v.x, v.y, v.expected,
                    v.got, v.differing);
    }
}

static void report_mismatch(const test_case &c, const Verdict &v, Subject s, unsigned mends)
{
    std::printf("MISMATCH mode %s, memory %s, %s\n", case_mode_name(c.mode), c.memory ? "small" : "fast", subject_name(s));
    report(c, v, "as drawn");
    const test_case small = shrink(c, s, mends);
    const Pair pair = render(small);
    report(small, compare(small, pair, oracle(small, pair), s, mends), "smallest");
}

// Every subject and memory plan against one map of OpenCV's. Prints the first mismatch when `pair` was rendered.
static bool check(const Options &o, test_case c, const Pair &pair, bool rendered, Tally &t)
{
    std::vector<int16_t> expected;
    t.cases++;
    if (o.subjects[0] != Subject::Reference) {
        case_settle(&c);
    }
    try {
        expected = oracle(c, pair);
    } catch (const std::exception &e) {
        std::printf("OPENCV THREW %s\n", e.what());
        report(c, Verdict{false, "OpenCV refuses the case", 0, 0, 0, 0, 0}, "case");
        return false;
    }
    for (int memory : o.memories) {
        for (Subject s : o.subjects) {
            c.memory = memory;
            const Verdict v = compare(c, pair, expected, s, o.mends);
            t.comparisons++;
            t.differing += v.differing;
            if (v.same) {
                continue;
            }
            if (rendered) {
                report_mismatch(c, v, s, o.mends);
            } else {
                std::printf("MISMATCH memory %s, %s\n", memory ? "small" : "fast", subject_name(s));
                report(c, v, "parameters");
            }
            return false;
        }
    }
    return true;
}

static void progress(int mode, long done, long all)
{
    if (isatty(2) && (done % 20 == 0 || done == all)) {
        std::fprintf(stderr, "\r%s %ld / %ld%s", case_mode_name(mode), done, all, done == all ? "\n" : "");
    }
}

static int run_random(const Options &o)
{
    for (int mode : o.modes) {
        Tally t;
        for (long i = 0; i < o.random; i++) {
            test_case c;
            case_random(&c, o.seed, uint32_t(i), mode, o.kinds == 2 ? int(i & 1) : o.kinds);
            if (!check(o, c, render(c), true, t)) {
                std::printf("%s: FAILED at case %ld of seed %lu\n", case_mode_name(mode), i, (unsigned long)o.seed);
                return 1;
            }
            progress(mode, i + 1, o.random);
        }
        std::printf("%s: %ld cases, %ld comparisons with OpenCV %s, seed %lu: 0 differing pixels\n", case_mode_name(mode), t.cases,
                    t.comparisons, oracle_version().c_str(), (unsigned long)o.seed);
        std::fflush(stdout);
    }
    return 0;
}

static int run_one(Options &o)
{
    Pair pair = o.replay ? render(o.one) : load(o.files[0], o.files[1], o.color);
    o.one.width = pair.width;
    o.one.height = pair.height;
    o.one.channels = pair.channels;
    for (int mode : o.modes) {
        Tally t;
        o.one.mode = mode;
        if (!case_defined(&o.one)) {
            std::fprintf(stderr, "stad-verify: outside the defined domain (docs/SPEC.md, section 1) in mode %s\n", case_mode_name(mode));
            return 2;
        }
        if (!check(o, o.one, pair, o.replay, t)) {
            return 1;
        }
        std::printf("%s: %dx%d, %ld comparisons with OpenCV %s: 0 differing pixels\n", case_mode_name(mode), pair.width,
                    pair.height, t.comparisons, oracle_version().c_str());
    }
    return 0;
}

static int run_bench(Options &o)
{
    if (!o.replay && o.files.empty()) {
        o.one.width = 640, o.one.height = 480, o.one.channels = o.color ? 3 : 1;
        o.one.view = scene{1, SCENE_SHIFT, 0, 0, o.one.params.min_disparity, o.one.params.num_disparities};
    }
    const Pair pair = o.files.empty() ? render(o.one) : load(o.files[0], o.files[1], o.color);
    o.one.width = pair.width;
    o.one.height = pair.height;
    o.one.channels = pair.channels;
    std::printf("OpenCV %s, one thread, thread-CPU time\n", oracle_version().c_str());
    for (int mode : o.modes) {
        for (int memory : o.memories) {
            o.one.mode = mode;
            o.one.memory = memory;
            if (!case_defined(&o.one)) {
                std::fprintf(stderr, "stad-verify: outside the defined domain (docs/SPEC.md, section 1) in mode %s\n", case_mode_name(mode));
                return 2;
            }
            bench(o.one, pair, o.seconds);
        }
    }
    return 0;
}

static long number(const char *name, const char *text, long lo, long hi)
{
    char *end;
    const long v = std::strtol(text, &end, 10);
    if (*text == 0 || *end != 0 || v < lo || v > hi) {
        bad_usage(std::string("--") + name + " takes a number from " + std::to_string(lo) + " to " + std::to_string(hi) +
                  ", not '" + text + "'");
    }
    return v;
}

static void parse_scene(Options &o, const char *text)
{
    char kind[16];
    unsigned long seed;
    scene &v = o.one.view;
    if (std::sscanf(text, "%15[a-z]:%lu:%d:%d:%d:%d", kind, &seed, &v.x0, &v.y0, &v.disp_min, &v.disp_count) != 6 ||
        scene_kind_of(kind) < 0) {
        bad_usage("--scene takes KIND:SEED:X0:Y0:DMIN:DCOUNT");
    }
    v.seed = uint32_t(seed);
    v.kind = scene_kind_of(kind);
}

static void parse_choice(Options &o, const std::string &name, const std::string &arg)
{
    if (name == "mode") {
        o.modes = arg == "all" ? std::vector<int>{0, 1, 2, 3} : std::vector<int>{case_mode_of(arg.c_str())};
        if (o.modes[0] < 0) {
            bad_usage("--mode takes sgbm, hh, 3way, hh4 or all");
        }
    } else if (name == "memory") {
        if (arg != "fast" && arg != "small" && arg != "both") {
            bad_usage("--memory takes fast, small or both");
        }
        o.memories = arg == "fast"    ? std::vector<int>{STAD_MEMORY_FAST}
                     : arg == "small" ? std::vector<int>{STAD_MEMORY_SMALL}
                                      : std::vector<int>{STAD_MEMORY_FAST, STAD_MEMORY_SMALL};
    } else if (name == "subject") {
        if (arg != "library" && arg != "reference") {
            bad_usage("--subject takes library or reference");
        }
        if (arg == "reference") {
            o.subjects = {Subject::Reference};
            o.memories = {STAD_MEMORY_FAST};
        }
    } else if (name == "mend") {
        int i = 0;
        while (i < MEND_COUNT && arg != reference_mend_name(i)) {
            i++;
        }
        if (i == MEND_COUNT) {
            bad_usage("--mend: no such quirk: " + arg);
        }
        o.mends |= 1u << i;
    } else {
        parse_scene(o, arg.c_str());
    }
}

static void parse_number(Options &o, const std::string &name, const char *arg)
{
    stad_params &p = o.one.params;
    const struct {
        const char *name;
        int16_t *field;
    } small[] = {{"min-disparity", &p.min_disparity},       {"num-disparities", &p.num_disparities},
                 {"block-size", &p.block_size},             {"p1", &p.p1},
                 {"p2", &p.p2},                             {"disp12-max-diff", &p.disp12_max_diff},
                 {"pre-filter-cap", &p.pre_filter_cap},     {"uniqueness-ratio", &p.uniqueness_ratio}};
    for (const auto &s : small) {
        if (name == s.name) {
            *s.field = int16_t(number(s.name, arg, -32768, 32767));
            return;
        }
    }
    if (name == "speckle-window-size") {
        p.speckle_window_size = int32_t(number("speckle-window-size", arg, -1, 1 << 30));
    } else if (name == "speckle-range") {
        p.speckle_range = int32_t(number("speckle-range", arg, 0, 4096));
    } else if (name == "random") {
        o.random = number("random", arg, 1, 100000000);
    } else if (name == "bench") {
        o.bench = true;
        o.seconds = double(number("bench", arg, 1, 3600));
    } else if (name == "seed") {
        o.seed = uint32_t(number("seed", arg, 0, 0xffffffffL));
    } else if (name == "interleave") {
        o.one.interleave = uint32_t(number("interleave", arg, 0, 0xffffffffL));
    } else {
        o.replay = true;
        int &field = name == "width" ? o.one.width : name == "height" ? o.one.height : o.one.channels;
        field = int(number(name.c_str(), arg, 1, 32767));
    }
}

static Options parse(int argc, char **argv)
{
    static const char *const choices[] = {"mode", "memory", "subject", "mend", "scene"};
    static const char *const numbers[] = {"min-disparity", "num-disparities", "block-size", "p1", "p2", "disp12-max-diff",
                                          "pre-filter-cap", "uniqueness-ratio", "speckle-window-size", "speckle-range", "random",
                                          "seed", "interleave", "width", "height", "channels", "bench"};
    static const char *const flags[] = {"stress", "ordinary", "color", "gray", "golden", "help"};
    std::vector<option> table;
    for (const char *n : choices) table.push_back({n, required_argument, nullptr, 'c'});
    for (const char *n : numbers) table.push_back({n, required_argument, nullptr, 'n'});
    for (const char *n : flags) table.push_back({n, no_argument, nullptr, 'f'});
    table.push_back({nullptr, 0, nullptr, 0});
    Options o;
    stad_params_sample(&o.one.params, 64, 3, 1);
    bool given_p1 = false, given_p2 = false;
    for (int index = 0, kind; (kind = getopt_long(argc, argv, "", table.data(), &index)) != -1;) {
        const std::string name = kind == '?' ? "" : table[size_t(index)].name;
        given_p1 |= name == "p1";
        given_p2 |= name == "p2";
        if (kind == 'c') {
            parse_choice(o, name, optarg);
        } else if (kind == 'n') {
            parse_number(o, name, optarg);
        } else if (name == "help") {
            std::fputs(usage_text, stdout);
            std::exit(0);
        } else if (kind == 'f') {
            o.kinds = name == "stress" ? 1 : name == "ordinary" ? 0 : o.kinds;
            o.color |= name == "color";
            o.golden |= name == "golden";
        } else {
            bad_usage("unknown option");
        }
    }
    stad_params sample;
    stad_params_sample(&sample, o.one.params.num_disparities, o.one.params.block_size, o.color ? 3 : 1);
    o.one.params.p1 = given_p1 ? o.one.params.p1 : sample.p1;
    o.one.params.p2 = given_p2 ? o.one.params.p2 : sample.p2;
    o.files.assign(argv + optind, argv + argc);
    return o;
}

int main(int argc, char **argv)
{
    Options o = parse(argc, argv);
    try {
        if (o.golden) {
            print_golden();
            return 0;
        }
        if (o.bench && (o.files.empty() || o.files.size() == 2)) {
            return run_bench(o);
        }
        if (o.random > 0 && o.files.empty()) {
            return run_random(o);
        }
        if (o.replay ? o.one.width && o.one.height && o.one.channels : o.files.size() == 2) {
            return run_one(o);
        }
    } catch (const std::runtime_error &e) {
        std::fprintf(stderr, "stad-verify: %s\n", e.what());
        return 3;
    }
    bad_usage("two images, --random N or a case to replay, please");
}
