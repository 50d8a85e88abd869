// SPDX-License-Identifier: MIT
#include "app/report/results.h"

namespace shadowlab::report {

std::string PointKey::name() const {
    std::string name = technique;
    for (const std::string& setting : settings)
        name += " " + setting;
    return name;
}

double Errors::shown() const { return truth == judge::TruthOf::area ? rmse : edgeErrorPx.value_or(0); }

std::string Group::name() const { return scene + "@" + light + (truth == judge::TruthOf::area ? "-area" : ""); }

} // namespace shadowlab::report
