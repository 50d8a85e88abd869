// The matrix of form factors as a picture, with its row sums.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/frame.h"
#include "techniques/radiosity/form_factors/prepared_exchange.h"

namespace shadowlab::radiosity {

/// Publishes stage `matrix`: F_jk in row j and column k, each pixel the mean of the numbers that it covers, on a logarithmic scale; to its
/// right a bar for each row, as long as the row's sum.
void publishMatrix(Frame& frame, const PreparedExchange& exchange);

} // namespace shadowlab::radiosity
