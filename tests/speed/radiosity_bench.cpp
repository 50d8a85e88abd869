// What radiosity costs and how exact it is.
//
//   ninja -C build/release radiosity_bench
//   build/release/tests/radiosity_bench [--plots FOLDER] growth [HALVINGS]    (3)
//   build/release/tests/radiosity_bench [--plots FOLDER] solvers [COUNT]      (2000)
//   build/release/tests/radiosity_bench [--plots FOLDER] hemicube [COUNT]     (1000)
//
// To be run from the folder that holds assets/. COUNT is how many patches there are at most, before they are cut where
// things touch.
//   growth    time, memory and what is wrong with the radiosity, for patches halved so many times; 3: 20,000 patches, for which it takes
//             3 GB and some four minutes (radiosity_growth.cpp)
//   solvers   what each solver knows of its error and what the error is, against time (radiosity_solvers.cpp)
//   hemicube  form factors by drawing beside exact ones, at several sizes of the picture (radiosity_hemicube.cpp)
// SPDX-License-Identifier: MIT
#include "tests/speed/radiosity_bench.h"

#include <cstdio>
#include <string>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/trace/parallel.h"

int main(int count, char** arguments) {
    using namespace shadowlab;
    try {
        std::vector<std::string> words(arguments + 1, arguments + count);
        std::string plots;
        if (words.size() >= 2 && words[0] == "--plots") {
            plots = words[1];
            words.erase(words.begin(), words.begin() + 2);
        }
        if (words.size() == 2 &&
            (words[1].empty() || words[1].size() > 6 || words[1].find_first_not_of("0123456789") != std::string::npos))
            throw Error(ExitStatus::usage, "'" + words[1] + "' is no number; give one like 2000");
        const auto number = [&](int otherwise) { return words.size() == 2 ? std::stoi(words[1]) : otherwise; };
        std::printf("radiosity_bench");
        for (int i = 1; i < count; ++i)
            std::printf(" %s", arguments[i]);
        std::printf("   (%d threads)\n", trace::threadCount());
        const std::string part = words.empty() || words.size() > 2 ? "" : words[0];
        const int halvings = number(3);
        if (part == "growth" ? halvings > 3 : number(0) > 20000) // 20,000 patches: 3 GB
            throw Error(ExitStatus::overLimit,
                        "so many patches are too many; give 3 halvings or 20000 patches at most");
        if (part == "growth")
            radiosity::benchGrowth(halvings, plots);
        else if (part == "solvers")
            radiosity::benchSolvers(static_cast<std::size_t>(number(2000)), plots);
        else if (part == "hemicube")
            radiosity::benchHemicube(static_cast<std::size_t>(number(1000)), plots);
        else
            throw Error(ExitStatus::usage,
                        "what is to be measured is not said; give [--plots FOLDER] growth|solvers|hemicube [NUMBER]");
    } catch (const Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return static_cast<int>(error.status());
    }
}
