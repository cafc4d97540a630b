// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_DATASET_WRITE_DATASET_H_
#define JPRIM_DATASET_WRITE_DATASET_H_

#include <string>

#include "jprim/dataset/dataset.h"

namespace jprim {

/// The dataset as text that readDataset() reads, and Adams/Solver too if it has no FLEX_BODY. Numbers carry
/// the digits that reproduce them exactly; angles are written in radians.
/// `readDataset(writeDataset(d)) == d`.
std::string writeDataset(const Dataset& dataset);

}  // namespace jprim

#endif
