// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_DATASET_TEXT_H_
#define JPRIM_SRC_DATASET_TEXT_H_

#include "base/text.h"

#endif
