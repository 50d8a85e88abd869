// For builds with the address sanitizer: a library that was loaded stays loaded. Leaks are looked for when the program ends, and
// Mesa's drivers are gone by then: their memory would be reported as that of unknown modules, which no suppression can name.
// SPDX-License-Identifier: MIT

extern "C" int dlclose(void* /*handle*/) { return 0; }
