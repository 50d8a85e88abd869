// A library to be loaded before all others (LD_PRELOAD): those that REFUSED_LIBRARIES names, with colons between, are not
// there, however a program asks for them at run time.
// SPDX-License-Identifier: MIT
#include <dlfcn.h>

#include <cstdlib>
#include <string>

extern "C" void* dlopen(const char* name, int flags) {
    static const auto next = reinterpret_cast<void* (*)(const char*, int)>(::dlsym(RTLD_NEXT, "dlopen"));
    const char* listed = std::getenv("REFUSED_LIBRARIES");
    std::string rest = name && listed ? std::string(listed) + ":" : "";
    for (std::size_t end = rest.find(':'); end != std::string::npos; end = rest.find(':')) {
        if (end > 0 && std::string(name).find(rest.substr(0, end)) != std::string::npos)
            return next("/none/refused.so", flags); // so that dlerror() has something to say
        rest.erase(0, end + 1);
    }
    return next(name, flags);
}
