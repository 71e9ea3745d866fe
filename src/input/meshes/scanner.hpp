#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace corpuscle {

/// A mesh file in memory, read from front to end as words and lines or as bytes; knows where it stands and says so in errors.
class Scanner {
public:
    /// Takes the whole file; refuses (InputError) one that cannot be read.
    static Scanner open(const std::string& file);
    Scanner(std::string file, std::string text) : file_(std::move(file)), text_(std::move(text)) {}

    [[nodiscard]] std::string_view rest() const { return std::string_view(text_).substr(position_); }
    [[nodiscard]] std::size_t size() const { return text_.size(); }
    [[nodiscard]] const std::string& file() const { return file_; }

    /// The rest of the line without its end; moves to the next.
    std::string_view line();
    /// Goes to the end of the file.
    void skip_rest() { position_ = text_.size(); }
    /// The next word on this line, empty at its end: for what must not run into the next line.
    std::string_view word_on_line();
    /// The next word on any line; refuses the file's end, where `what` was expected. Empty words do not occur.
    std::string_view word(const char* what);
    double real(const char* what);           ///< finite number
    std::int64_t integer(const char* what);  ///< whole number
    /// Whether only blanks are left.
    [[nodiscard]] bool at_end();
    /// Moves behind the next line that begins with `mark`; refuses if there is none.
    void skip_past_line(std::string_view mark);

    /// Bytes as they are, for binary files: numbers in this machine's order.
    template <class T>
    T bytes(const char* what);
    /// Refuses a number of records that cannot fit in what is left of the file, so that a wrong count never asks for memory.
    std::size_t count(std::int64_t records, std::size_t least_bytes, const char* what);

    /// Errors then tell the byte, not the line.
    void set_binary(bool binary) { binary_ = binary; }
    [[noreturn]] void fail(const std::string& problem, const std::string& remedy) const;

private:
    void skip_blanks();

    std::string file_;
    std::string text_;
    std::size_t position_ = 0;
    std::size_t last_ = 0;  ///< where the last thing read began: the place of an error
    bool binary_ = false;
};

}  // namespace corpuscle
