// A shared library loaded at run time, so that the program starts on machines that do not have it.
// SPDX-License-Identifier: MIT
#pragma once
#include <dlfcn.h>

#include <initializer_list>
#include <string>
#include <string_view>

namespace shadowlab::context {

/// Loads the first of `names` that is there. Never unloaded: drivers leave thread-local data and exit handlers behind
/// that would point into nothing.
class Library {
public:
    Library(std::initializer_list<const char*> names) {
        for (const char* name : names) {
            if (!handle_) handle_ = ::dlopen(name, RTLD_NOW | RTLD_LOCAL);
            if (handle_ || !fault_.empty()) break;
            const char* const why = ::dlerror();
            if (why && std::string_view(why).find("No such file") == std::string_view::npos) fault_ = why;
        }
    }
    [[nodiscard]] bool loaded() const { return handle_ != nullptr; }
    /// Why one that is there cannot be loaded; empty: it is not there.
    [[nodiscard]] const std::string& fault() const { return fault_; }

    /// Fills in a function pointer; false when the library has no such function.
    template <typename Function>
    bool find(Function& function, const char* name) const {
        function = handle_ ? reinterpret_cast<Function>(::dlsym(handle_, name)) : nullptr;
        return function != nullptr;
    }

private:
    void* handle_ = nullptr;
    std::string fault_;
};

} // namespace shadowlab::context
