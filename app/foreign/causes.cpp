// SPDX-License-Identifier: MIT
#include "app/foreign/causes.h"

#include <algorithm>
#include <cmath>

#include "app/picture/verdict_reasons.h"

namespace shadowlab::foreign {

std::string percentText(double share) { return picture::fixed(100 * share, 0) + " %"; }

std::string metresText(double metres) {
    return metres < 0.1 ? picture::fixed(100 * metres, metres < 0.01 ? 2 : 1) + " cm" : picture::fixed(metres, 2) + " m";
}

void addIfExplains(const Evidence& evidence, Cause cause, std::vector<Cause>& causes) {
    if (explained(evidence, cause.predictions) >= kLeastExplained) causes.push_back(std::move(cause));
}

std::vector<double> patternSearch(std::vector<double> place, double step, double leastStep,
                                  const std::function<double(const std::vector<double>&)>& costOf) {
    double cost = costOf(place);
    while (step >= leastStep) {
        std::vector<double> best = place;
        double bestCost = cost;
        const auto attempt = [&](const std::vector<double>& tried) {
            if (const double found = costOf(tried); found < bestCost) bestCost = found, best = tried;
        };
        for (std::size_t axis = 0; axis < place.size(); ++axis)
            for (const double way : {-step, step}) {
                std::vector<double> tried = place;
                tried[axis] += way;
                attempt(tried);
                // Along two axes at once: valleys lie askew.
                for (std::size_t other = axis + 1; other < place.size(); ++other)
                    for (const double otherWay : {-step, step}) {
                        std::vector<double> both = tried;
                        both[other] += otherWay;
                        attempt(both);
                    }
            }
        if (bestCost < cost)
            cost = bestCost, place = best;
        else
            step /= 2;
    }
    return place;
}

Threshold bestThreshold(const Evidence& evidence, const std::vector<double>& values) {
    // From the least value up, one sample after the other becomes lit.
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (std::isfinite(values[i]) && !evidence.samples[i].shouldBeLit) order.push_back(i);
    std::ranges::sort(order, {}, [&](std::size_t i) { return values[i]; });
    double gain = 0, most = 0;
    std::size_t count = 0;
    for (std::size_t k = 0; k < order.size(); ++k) {
        const Sample& sample = evidence.samples[order[k]];
        gain += sample.isLit ? sample.weight : -sample.weight;
        if (gain > most) most = gain, count = k + 1;
    }
    Threshold best;
    best.predictions.resize(values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        best.predictions[i] = predicted(evidence.samples[i].shouldBeLit);
    for (std::size_t k = 0; k < count; ++k)
        best.predictions[order[k]] = Prediction::lit;
    if (count > 0) best.value = values[order[count - 1]];
    best.explained = explained(evidence, best.predictions);
    return best;
}

} // namespace shadowlab::foreign
