// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_BASE_ERROR_H_
#define JPRIM_BASE_ERROR_H_

#include <stdexcept>
#include <string>

namespace jprim {

/// A caller's mistake or a failed simulation. The message reads `element: what is wrong and what to do`.
class Error : public std::runtime_error {
public:
    /// @param element  what the message is about, for example "InLine JPRIM/12"
    /// @param message  the value that is wrong, and the remedy
    Error(const std::string& element, const std::string& message);

    /// The element named at construction.
    const std::string& getElement() const { return m_element; }

private:
    std::string m_element;
};

}  // namespace jprim

#endif
