// Values as bytes, sent between processes on the same machine.
#pragma once

#include "common/contract/fields.hpp"

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>

namespace rt::contract {

/// Thrown for bytes that are invalid: too few, too many, or without a meaning.
struct Malformed : std::runtime_error {
    using std::runtime_error::runtime_error;
};

class Writer {
public:
    void raw(const void* from, std::size_t count) {
        bytes_.append(static_cast<const char*>(from), count);
    }
    [[nodiscard]] const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
};

class Reader {
public:
    explicit Reader(std::string_view bytes) : left_(bytes) {}

    void raw(void* to, std::size_t count) {
        if (count > left_.size()) throw Malformed("it ends too early");
        std::memcpy(to, left_.data(), count);
        left_.remove_prefix(count);
    }
    [[nodiscard]] std::size_t left() const { return left_.size(); }
    /// Must be called after the last value has been read.
    void end() const {
        if (!left_.empty()) throw Malformed("it is too long");
    }

private:
    std::string_view left_;
};

template <class T>
void put(Writer& to, const T& value) {
    if constexpr (std::is_same_v<T, bool>) {
        put(to, std::uint8_t(value));
    } else if constexpr (is_number<T>) {
        to.raw(&value, sizeof value);
    } else if constexpr (is_optional<T>) {
        put(to, value.has_value());
        if (value) put(to, *value);
    } else if constexpr (is_sequence<T>) {
        put(to, std::uint32_t(value.size()));
        for (const auto& part : value) put(to, part);
    } else {
        for_each_part(value, [&](const auto& part) { put(to, part); });
    }
}

template <class T>
T get(Reader& from) {
    T value{};
    if constexpr (std::is_same_v<T, bool>) {
        const auto byte = get<std::uint8_t>(from);
        if (byte > 1) throw Malformed("a byte that is neither true nor false");
        value = byte == 1;
    } else if constexpr (is_number<T>) {
        from.raw(&value, sizeof value);
    } else if constexpr (is_optional<T>) {
        if (get<bool>(from)) value = get<typename T::value_type>(from);
    } else if constexpr (is_sequence<T>) {
        // One by one: a count that promises more than there is costs no memory.
        for (auto count = get<std::uint32_t>(from); count > 0; --count)
            value.push_back(get<typename T::value_type>(from));
    } else {
        for_each_part(value, [&](auto& part) { part = get<std::decay_t<decltype(part)>>(from); });
    }
    return value;
}

}  // namespace rt::contract
