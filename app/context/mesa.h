// What has to be done about Mesa's drivers before the first context is made.
// SPDX-License-Identifier: MIT
#pragma once


namespace shadowlab::context {

/// Some environment variables of Mesa crash the program in the middle of a picture, others silently leave a part of every picture
/// out. Throws Unavailable with the name of the first of these that is set. Every factory of contexts begins with this.
void requireUsableSettings();

/// llvmpipe hangs when the system refuses it a thread (ulimit -u, a container's limit of processes). So as many threads are started
/// here, all at one time; where that fails, llvmpipe is made to draw without threads (LP_NUM_THREADS=0). The pictures are the same.
/// Called before the first context is made; later calls do nothing.
void doWithoutRefusedThreads();

/// Where the address space is limited (`ulimit -v`), makes all threads share one malloc arena. glibc otherwise reserves 64 MB of
/// addresses for each thread that allocates, most of them unused, and Mesa crashes when an allocation fails. One arena is slower, but
/// leaves the limit to memory that is used. Called in main, before there are threads.
void spareAddresses();

} // namespace shadowlab::context
