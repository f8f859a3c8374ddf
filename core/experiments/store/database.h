#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace cullscope::store {

/// An SQLite file. Every failure is an Error that names the file.
class Database {
public:
    enum class Access {
        Write,     ///< a file that is not there is made
        Existing,  ///< the file must be there; where it cannot be written it can be read
    };
    /// Waits up to half a minute for other programs that write. Throws Error(Input) for what is no database.
    Database(const std::filesystem::path& file, Access access);

    void run(const char* sql) const;
    /// Writes into a log beside the file from now on (`PRAGMA journal_mode = WAL`), so that others read while one writes.
    void useWriteAheadLog() const;
    [[nodiscard]] int64_t newestRow() const;
    [[nodiscard]] const std::filesystem::path& file() const { return m_file; }

    /// Throws the Error of what SQLite answered last.
    [[noreturn]] void fail(int answer) const;
    /// Throws Error(Input): what stands in the file is no result store.
    [[noreturn]] void refuse() const;

private:
    friend class Statement;
    struct Close {
        void operator()(sqlite3* database) const;
    };
    /// False: SQLite cannot read it, for it cannot write beside it, as in a folder of others or on a full disk.
    [[nodiscard]] bool isReadable() const;
    void openToRead();

    std::filesystem::path m_file;
    std::unique_ptr<sqlite3, Close> m_handle;
};

/// A statement with its values; used once.
class Statement {
public:
    Statement(const Database& database, const char* sql);

    Statement& bind(std::string_view text);
    Statement& bind(int64_t number);
    Statement& bindNothing();

    /// Goes to the next row; false: there is none.
    [[nodiscard]] bool next();
    /// Runs a statement that has no rows.
    void run();

    [[nodiscard]] int64_t number(int column) const;
    [[nodiscard]] std::string text(int column) const;
    [[nodiscard]] bool isNothing(int column) const;

private:
    struct Close {
        void operator()(sqlite3_stmt* statement) const;
    };
    const Database& m_database;
    std::unique_ptr<sqlite3_stmt, Close> m_handle;
    int m_bound = 0;
};

/// All or nothing: what was written is there from commit() on, and without it nothing of it. Other programs wait meanwhile.
class Transaction {
public:
    /// To read alone, what others commit meanwhile is not seen: all that is read is of one moment.
    enum class Purpose { Write, Read };
    explicit Transaction(const Database& database, Purpose purpose = Purpose::Write);
    ~Transaction();
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;
    void commit();

private:
    const Database& m_database;
    bool m_open = true;
};

}  // namespace cullscope::store
