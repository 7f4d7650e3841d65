/* SPDX-License-Identifier: MIT
 * python/abi.c - what the Python package must know of the C types, told by the compiler. */
#include "stad/stad.h"

const char *stad_abi_version(void);
uint32_t stad_abi_bytes(int type);
const char *stad_abi_tier(void);
size_t stad_abi_speckle_bytes(int32_t width, int32_t height);

const char *stad_abi_version(void)
{
    return STAD_VERSION;
}

/* Bytes of the i-th type that the package mirrors or allocates; 0 past the last. */
uint32_t stad_abi_bytes(int type)
{
    static const uint32_t bytes[] = {
        sizeof(stad_params),       sizeof(stad_geometry),     sizeof(stad_image),  sizeof(stad_match),
        sizeof(stad_match_counts), sizeof(stad_tune_config),  sizeof(stad_tune),   sizeof(stad_tune_counts),
        sizeof(stad_score_config), sizeof(stad_score_counts), sizeof(stad_score),  sizeof(stad_mark),
        sizeof(stad_pair),         sizeof(stad_mark_config),  sizeof(stad_camera), sizeof(stad_rig),
        sizeof(stad_rig_report),   sizeof(stad_request),      sizeof(stad_setup),  sizeof(stad_monitor_config),
        sizeof(stad_calib_config), sizeof(stad_calib_report), sizeof(stad_truth),  sizeof(stad_calib),
        sizeof(stad_evaluator)};
    return type >= 0 && type < (int)(sizeof bytes / sizeof bytes[0]) ? bytes[type] : 0;
}

size_t stad_abi_speckle_bytes(int32_t width, int32_t height)
{
    return STAD_SPECKLE_BYTES(width, height);
}

/* The x86 port exports the name of the tier in use; another port does not have it. */
const char *stad_x86_tier_name(void) __attribute__((weak));

const char *stad_abi_tier(void)
{
    return stad_x86_tier_name ? stad_x86_tier_name() : "c";
}
