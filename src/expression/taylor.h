// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_EXPRESSION_TAYLOR_H_
#define JPRIM_SRC_EXPRESSION_TAYLOR_H_

namespace jprim {

/// A quantity (a Real or a Vec3) with its first and second time derivatives.
template <class T>
struct Taylor {
    T value{};
    T first{};
    T second{};
};

}  // namespace jprim

#endif
