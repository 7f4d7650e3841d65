// SPDX-License-Identifier: MIT
// stad-verify/verify.cpp - compares maps, and shrinks a case that differs.
#include "verify.hpp"

#include <cstdlib>
#include <functional>

#include "stad/status.h"
#include "support/reference.h"
#include "support/subject.h"

const char *subject_name(Subject s)
{
    return s == Subject::Frame ? "frame" : s == Subject::Rows ? "rows" : "reference";
}

Pair render(const test_case &c)
{
    Pair pair;
    pair.width = c.width;
    pair.height = c.height;
    pair.channels = c.channels;
    pair.left.resize(size_t(c.width) * size_t(c.height) * size_t(c.channels));
    pair.right.resize(pair.left.size());
    case_render(&c, pair.left.data(), pair.right.data());
    return pair;
}

Verdict compare(const test_case &c, const Pair &pair, const std::vector<int16_t> &expected, Subject subject, unsigned mends)
{
    std::vector<int16_t> got(expected.size());
    Verdict v;
    if (subject == Subject::Reference) {
        if (reference_match(&c.params, c.mode, mends, pair.left.data(), pair.right.data(), c.width, c.height, c.channels,
                            got.data()) < 0) {
            v.error = "the reference refuses the case";
        }
    } else {
        const char *why = "";
        const int form = subject == Subject::Frame ? SUBJECT_FRAME : SUBJECT_ROWS;
        const int status = subject_run(&c, form, pair.left.data(), pair.right.data(), got.data(), &why);
        if (status < 0) {
            v.error = std::string(status == SUBJECT_GUARD ? "guard" : stad_status_name(status)) + ": " + why;
        }
    }
    for (size_t i = 0; v.error.empty() && i < got.size(); i++) {
        if (got[i] != expected[i] && v.differing++ == 0) {
            v.x = int(i % size_t(c.width));
            v.y = int(i / size_t(c.width));
            v.expected = expected[i];
            v.got = got[i];
        }
    }
    v.same = v.error.empty() && v.differing == 0;
    return v;
}

static bool differs(const test_case &c, Subject subject, unsigned mends)
{
    if (!case_defined(&c)) {
        return false;
    }
    try {
        const Pair pair = render(c);
        return !compare(c, pair, oracle(c, pair), subject, mends).same;
    } catch (const std::exception &) {
        return false;
    }
}

// One way to make a case simpler; returns false when there is nothing to do.
using Cut = std::function<bool(test_case &)>;

template <class T> static Cut toward(T stad_params::*field, int goal)
{
    return [=](test_case &c) {
        const T before = c.params.*field;
        c.params.*field = T(goal + (before - goal) / 2);
        return c.params.*field != before;
    };
}

static Cut shorter(int test_case::*field, bool halve)
{
    return [=](test_case &c) {
        const int before = c.*field;
        c.*field = halve ? before / 2 : before - 1;
        return c.*field > 0 && c.*field < before;
    };
}

static std::vector<Cut> cuts()
{
    return {
        shorter(&test_case::height, true),
        shorter(&test_case::width, true),
        [](test_case &c) { return c.view.y0 += c.height / 2, c.height -= c.height / 2, c.height > 1; },
        [](test_case &c) { return c.view.x0 += c.width / 8, c.width -= c.width / 8, c.width > 8; },
        [](test_case &c) { return c.width -= c.width / 8, c.width > 8; },
        [](test_case &c) {
            c.params.num_disparities = int16_t(c.params.num_disparities / 2 & ~7);
            return c.params.num_disparities > 0;
        },
        [](test_case &c) { return c.params.num_disparities = int16_t(c.params.num_disparities - 8), true; },
        [](test_case &c) { return c.channels == 3 && (c.channels = 1); },
        toward(&stad_params::speckle_window_size, 0),
        toward(&stad_params::min_disparity, 0),
        [](test_case &c) { return c.params.block_size > 2 && (c.params.block_size = int16_t(c.params.block_size - 2)); },
        toward(&stad_params::block_size, 1),
        toward(&stad_params::uniqueness_ratio, 0),
        toward(&stad_params::disp12_max_diff, 500),
        toward(&stad_params::pre_filter_cap, 15),
        toward(&stad_params::p1, 1),
        toward(&stad_params::p2, 2),
        shorter(&test_case::height, false),
        shorter(&test_case::width, false),
        [](test_case &c) { return c.view.y0++, --c.height > 0; },
        [](test_case &c) { return c.view.x0++, --c.width > 0; },
    };
}

test_case shrink(test_case c, Subject subject, unsigned mends)
{
    int tries = 2000;
    for (bool progress = true; progress && tries > 0;) {
        progress = false;
        for (const Cut &cut : cuts()) {
            test_case smaller = c;
            while (tries-- > 0 && cut(smaller) && differs(smaller, subject, mends)) {
                c = smaller;
                progress = true;
            }
        }
    }
    return c;
}
