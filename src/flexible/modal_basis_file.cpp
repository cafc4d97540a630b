// SPDX-License-Identifier: Apache-2.0
// The file is text: a line of kind and version, then words each followed by its values, last a checksum of
// all bytes before it. Numbers have the digits that reproduce them.
#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "jprim/base/error.h"
#include "jprim/flexible/modal_basis.h"

namespace jprim {

using SimTK::Mat33;
using SimTK::Vec3;

namespace {

constexpr std::string_view Kind = "jprim-modes";
constexpr int Version = 1;
constexpr std::string_view ChecksumWord = "checksum ";

// FNV-1a, 64 bits: http://www.isthe.com/chongo/tech/comp/fnv
std::uint64_t calcChecksum(std::string_view text) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const unsigned char byte : text) hash = (hash ^ byte) * 0x100000001b3u;
    return hash;
}

//------------------------------------------------------------------------------------------ writing
class Writer {
public:
    void write(const ModalBasis& b) {
        add("{} {}\nname {}\n", Kind, Version, b.name);
        add("modes {}\nnodes {}\ninterfaces {}", b.getNumModes(), b.nodes.size(), b.interfaces.size());
        for (const int id : b.interfaces) add(" {}", id);
        add("\nmass {}\ncenter", b.rigid.mass);
        addVector(b.rigid.center);
        add("inertia");
        addSymmetric(b.rigid.inertia);
        add("frequencies\n");
        for (const double frequency : b.frequencies) add("{}\n", frequency);
        add("inertia_change\n");
        for (const Mat33& change : b.inertiaChange) addSymmetric(change);
        add("gyroscopic\n");
        for (const Vec3& n : b.gyroscopic) addVector(n);
        for (const ModalNode& node : b.nodes) {
            add("node {}", node.id);
            addVector(node.position);
            for (int k = 0; k < b.getNumModes(); ++k) {
                const Vec3 &t = node.translation[k], &r = node.rotation[k];
                add("{} {} {} {} {} {}\n", t[0], t[1], t[2], r[0], r[1], r[2]);
            }
        }
        add("{}{:016x}\n", ChecksumWord, calcChecksum({m_text.data(), m_text.size()}));
    }

    const fmt::memory_buffer& getText() const { return m_text; }

private:
    template <class... Arguments>
    void add(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        fmt::format_to(std::back_inserter(m_text), format, std::forward<Arguments>(arguments)...);
    }
    void addVector(const Vec3& v) { add(" {} {} {}\n", v[0], v[1], v[2]); }
    void addSymmetric(const Mat33& m) {
        add(" {} {} {} {} {} {}\n", m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(0, 2), m(1, 2));
    }

    fmt::memory_buffer m_text;
};

//------------------------------------------------------------------------------------------ reading
class Reader {
public:
    Reader(std::string_view text, const std::string& file) : m_text(text), m_file(file) {}

    ModalBasis read() {
        readKind();
        checkSum();
        ModalBasis b;
        expect("name");
        b.name = std::string(takeLine());
        expect("modes");
        const int modes = takeCount();
        expect("nodes");
        const int nodes = takeCount();
        expect("interfaces");
        for (int left = takeCount(); left > 0; --left) b.interfaces.push_back(take<int>());
        expect("mass");
        b.rigid.mass = take<double>();
        expect("center");
        b.rigid.center = takeVector();
        expect("inertia");
        b.rigid.inertia = takeSymmetric();
        expect("frequencies");
        for (int k = 0; k < modes; ++k) b.frequencies.push_back(take<double>());
        expect("inertia_change");
        for (int k = 0; k < modes; ++k) b.inertiaChange.push_back(takeSymmetric());
        expect("gyroscopic");
        for (int k = 0; k < modes * (modes - 1) / 2; ++k) b.gyroscopic.push_back(takeVector());
        for (int i = 0; i < nodes; ++i) b.nodes.push_back(takeNode(modes));
        expect("checksum");
        return b;
    }

private:
    [[noreturn]] void fail(const std::string& what) const {
        throw Error(fmt::format("{}:{}", m_file, m_line), what);
    }

    void readKind() {
        if (takeWord() != Kind)
            throw Error(m_file,
                        "is not a file of modes; `jprim reduce` makes one from a finite-element mesh");
        if (const int version = take<int>(); version != Version)
            throw Error(m_file,
                        fmt::format("has version {}; this program reads version {}", version, Version));
    }

    void checkSum() const {
        const std::size_t at = m_text.rfind(ChecksumWord);
        if (at == m_text.npos || m_text.back() != '\n')
            throw Error(m_file, "is cut off; copy it again or make it again with `jprim reduce`");
        const std::string expected =
            fmt::format("{}{:016x}\n", ChecksumWord, calcChecksum(m_text.substr(0, at)));
        if (m_text.substr(at) != expected)
            throw Error(m_file,
                        "has been changed since it was written (its checksum does not fit); copy it "
                        "again or make it again with `jprim reduce`");
    }

    std::string_view takeWord() {
        while (m_at < m_text.size() && (m_text[m_at] == ' ' || m_text[m_at] == '\n'))
            if (m_text[m_at++] == '\n') ++m_line;
        const std::size_t begin = m_at;
        while (m_at < m_text.size() && m_text[m_at] != ' ' && m_text[m_at] != '\n') ++m_at;
        return m_text.substr(begin, m_at - begin);
    }

    // The rest of the line after one blank.
    std::string_view takeLine() {
        const std::size_t begin = m_at + 1;
        m_at = std::min(m_text.find('\n', m_at), m_text.size());
        return begin < m_at ? m_text.substr(begin, m_at - begin) : std::string_view();
    }

    void expect(std::string_view word) {
        if (const std::string_view found = takeWord(); found != word)
            fail(fmt::format("'{}' is expected, not '{}'", word, found));
    }

    template <class Number>
    Number take() {
        const std::string_view word = takeWord();
        Number value{};
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc() || end != word.data() + word.size())
            fail(fmt::format("a number is expected, not '{}'", word));
        return value;
    }

    int takeCount() {
        const int count = take<int>();
        if (count < 0) fail(fmt::format("{} is no number of things", count));
        return count;
    }

    Vec3 takeVector() {
        Vec3 v;
        for (int k = 0; k < 3; ++k) v[k] = take<double>();
        return v;
    }

    Mat33 takeSymmetric() {
        const Vec3 d = takeVector(), o = takeVector();
        return Mat33(d[0], o[0], o[1], o[0], d[1], o[2], o[1], o[2], d[2]);
    }

    ModalNode takeNode(int modes) {
        expect("node");
        ModalNode node;
        node.id = take<int>();
        node.position = takeVector();
        for (int k = 0; k < modes; ++k) {
            node.translation.push_back(takeVector());
            node.rotation.push_back(takeVector());
        }
        return node;
    }

    std::string_view m_text;
    std::string m_file;
    std::size_t m_at = 0;
    int m_line = 1;
};

}  // namespace

void saveModalBasis(const ModalBasis& basis, const std::string& file) {
    Writer writer;
    writer.write(basis);
    std::ofstream stream(file, std::ios::binary);
    stream.write(writer.getText().data(), std::streamsize(writer.getText().size()));
    stream.close();
    if (!stream) throw Error(file, "cannot be written");
}

ModalBasis loadModalBasis(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream || std::filesystem::is_directory(file)) throw Error(file, "cannot be opened");
    std::ostringstream text;
    text << stream.rdbuf();
    const std::string content = text.str();
    return Reader(content, file).read();
}

}  // namespace jprim
