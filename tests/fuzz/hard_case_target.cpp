// Hard cases, in the place where the program's own ones lie.
// SPDX-License-Identifier: MIT
#include "app/hard/case.h"
#include "tests/fuzz/target.h"

namespace shadowlab::fuzz {

Outcome feed(std::string_view bytes) {
    const scene::LoadOptions options{.assetsRoot = kOwnAssets, .allowed = {}, .limits = {}};
    return outcomeOf([&] {
        const hard::Case one =
            hard::parseCase(std::string(bytes), options.assetsRoot / "hard" / "made-up.json", options);
        require(!hard::isBefore(one.id, one.id), "no case comes before itself");
        require(one.size.x > 0 && one.size.y > 0 && one.smallSize.x > 0 && one.smallSize.y > 0, "pictures have a size");
        for (const hard::Check& check : one.checks) {
            require(check.right.slots.size() == 1, "a check is of one technique");
            for (const hard::Expectation& expected : check.expectations)
                require(expected.bound.atLeast || expected.bound.atMost, "an expectation has a bound");
        }
    });
}

} // namespace shadowlab::fuzz
