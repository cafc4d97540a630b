// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_DATASET_NUMBERS_H_
#define JPRIM_SRC_DATASET_NUMBERS_H_

#include "base/numbers.h"

#endif
