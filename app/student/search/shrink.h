// The smallest scene that still fails: parts are taken away as long as it does (delta debugging, A. Zeller and R. Hildebrandt, Simplifying
// and Isolating Failure-Inducing Input, IEEE Transactions on Software Engineering 28, 2002), and what is left is put on round numbers.
// SPDX-License-Identifier: MIT
#pragma once
#include <functional>

#include "app/student/search/search_scene.h"

namespace shadowlab::student {

struct Shrunk {
    SearchScene scene;
    int attempts = 0;
};

/// `stillFails` is asked about ever smaller scenes; `scene` itself fails. `mayGoOn`: false ends it with what has been reached. Same scene and same
/// answers, same result.
Shrunk shrink(const SearchScene& scene, const std::function<bool(const SearchScene&)>& stillFails, const std::function<bool()>& mayGoOn);

} // namespace shadowlab::student
