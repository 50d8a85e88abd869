// SPDX-License-Identifier: MIT
#include "techniques/probe_decision.h"

#include <utility>

#include "techniques/probed/seen_point.h"

namespace shadowlab {

bool isWrong(double visibility, trace::Visibility truth) {
    return (visibility > 0.5) != (truth == trace::Visibility::lit);
}

void addDecision(Probe& probe, double visibility, trace::Visibility truth, const std::string& why) {
    const bool turnedAway = truth == trace::Visibility::turnedAway, wrong = isWrong(visibility, truth);
    std::string text = turnedAway && !wrong ? "turned away from the light, or outside its cone"
                       : visibility == 1    ? "lit"
                       : visibility == 0    ? "in shadow"
                                            : probeText(visibility) + " of the light arrives";
    probe.facts.push_back({"decision", std::move(text), "", {visibility}});
    if (wrong)
        probe.facts.push_back({"error", std::string(visibility > 0.5 ? "false lit: " : "false shadow: ") + why, ""});
    probe.decision = Decision{visibility, turnedAway, wrong ? why : ""};
}

void addDecider(Probe& probe, std::string who) {
    probe.add(Decider{who});
    probe.facts.push_back({"who decides", std::move(who), ""});
}

} // namespace shadowlab
