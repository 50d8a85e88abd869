// SPDX-License-Identifier: MIT
#include "app/figures/rays/shown_tree.h"

#include <algorithm>

namespace shadowlab::figures {

namespace {

bool isShadowRay(const Probe::Node& node) { return node.light >= 0; }

int levelOf(const Probe& probe, int ray) {
    int level = 0;
    for (int i = probe.tree[static_cast<std::size_t>(ray)].parent; i >= 0;
         i = probe.tree[static_cast<std::size_t>(i)].parent)
        ++level;
    return level;
}

} // namespace

bool ShownTree::shows(int ray) const { return std::ranges::binary_search(rays, ray); }

ShownTree shownTree(const Probe& probe, int mostEnds, int mostLevels) {
    std::vector<int> all;
    for (int i = 0; i < static_cast<int>(probe.tree.size()); ++i)
        if (!isShadowRay(probe.tree[static_cast<std::size_t>(i)])) all.push_back(i);
    const auto node = [&](int i) -> const Probe::Node& { return probe.tree[static_cast<std::size_t>(i)]; };
    std::ranges::stable_sort(all, [&](int a, int b) { return node(a).share > node(b).share; });

    ShownTree shown;
    std::vector<int> children(probe.tree.size(), 0);
    int ends = 0;
    for (const int ray : all) {
        const int parent = node(ray).parent;
        // No share is larger than that of the ray it comes from, so that one has had its turn.
        const bool hangsOn = parent < 0 || shown.shows(parent);
        const bool isFirst = parent < 0 || children[static_cast<std::size_t>(parent)] == 0;
        const int endsWith = parent < 0 ? 1 : ends + (isFirst ? 0 : 1);
        if (!hangsOn || endsWith > mostEnds || levelOf(probe, ray) >= mostLevels) {
            ++shown.leftOut;
            shown.largestLeftOut = std::max(shown.largestLeftOut, node(ray).share);
            continue;
        }
        ends = endsWith;
        if (parent >= 0) ++children[static_cast<std::size_t>(parent)];
        shown.rays.insert(std::ranges::lower_bound(shown.rays, ray), ray);
    }
    for (int i = 0; i < static_cast<int>(probe.tree.size()); ++i)
        if (isShadowRay(node(i)) && node(i).segment >= 0 && shown.shows(node(i).parent)) shown.shadowRays.push_back(i);
    return shown;
}

} // namespace shadowlab::figures
