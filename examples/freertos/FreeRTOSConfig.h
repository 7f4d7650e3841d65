/* SPDX-License-Identifier: MIT
 * examples/freertos/FreeRTOSConfig.h - everything static, preemptive, no timers. */
#ifndef FREERTOS_CONFIG_H
#define FREERTOS_CONFIG_H

#define configUSE_PREEMPTION                 1
#define configUSE_IDLE_HOOK                  0
#define configUSE_TICK_HOOK                  0
#define configCPU_CLOCK_HZ                   25000000
#define configTICK_RATE_HZ                   1000
#define configTICK_TYPE_WIDTH_IN_BITS        TICK_TYPE_WIDTH_32_BITS
#define configMAX_PRIORITIES                 5
#define configMINIMAL_STACK_SIZE             128
#define configMAX_TASK_NAME_LEN              8
#define configSUPPORT_STATIC_ALLOCATION      1
#define configSUPPORT_DYNAMIC_ALLOCATION     0
#define configUSE_MUTEXES                    0
#define configUSE_TIMERS                     0
#define configCHECK_FOR_STACK_OVERFLOW       0
#define configENABLE_FPU                     1
#define configENABLE_MPU                     0
#define configPRIO_BITS                      3
#define configKERNEL_INTERRUPT_PRIORITY      (7 << (8 - configPRIO_BITS))
#define configMAX_SYSCALL_INTERRUPT_PRIORITY (5 << (8 - configPRIO_BITS))

#define INCLUDE_vTaskDelay 1

#endif
