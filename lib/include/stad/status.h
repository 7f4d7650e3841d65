/* SPDX-License-Identifier: MIT
 * stad/status.h - what every function of the library answers.
 *
 * A negative value is a status; zero is success; where a function counts or numbers rows, the count or the row number is
 * returned as it is, so `< 0` is the one test for failure. Nothing is repaired in silence: a call that answers with an
 * error has changed nothing but what its comment says. */
#ifndef STAD_STATUS_H
#define STAD_STATUS_H

#ifdef __cplusplus
extern "C" {
#endif

/* The statuses. */
enum stad_status {
    STAD_OK = 0,
    STAD_AGAIN = -1,     /* nothing ready yet: do the other half first (push before pull, pull before push) */
    STAD_E_PARAM = -2,   /* a value is outside its domain; calls with a culprit name it */
    STAD_E_SIZE = -3,    /* an image, a buffer or a workspace has the wrong size or alignment */
    STAD_E_STATE = -4,   /* the call does not fit the state of the object */
    STAD_E_LIMIT = -5,   /* a valid request above what the geometry reserved memory for */
    STAD_E_CORRUPT = -6, /* stored or received data fail their check */
    STAD_E_NO_MARK = -7, /* too few fiducial marks to do the job */
    STAD_E_RIG = -8      /* the rectification is out of bounds: tuning would be pointless */
};

/* The name of a status, such as "STAD_E_PARAM"; "STAD_OK" for zero and every positive value, "STAD_E_UNKNOWN" for others.
 * The string is constant and never freed. */
const char *stad_status_name(int status);

#ifdef __cplusplus
}
#endif

#endif
