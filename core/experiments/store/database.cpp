#include "core/experiments/store/database.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include <cerrno>
#include <chrono>
#include <thread>

#include "core/base/error.h"

namespace cullscope::store {
namespace {

constexpr std::chrono::milliseconds kPatience{30'000};  // that another program may write
constexpr std::chrono::milliseconds kBetweenTries{2};

}  // namespace

void Database::Close::operator()(sqlite3* database) const { sqlite3_close_v2(database); }
void Statement::Close::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }

Database::Database(const std::filesystem::path& file, Access access) : m_file(file) {
    std::error_code unknown;  // where one cannot tell, opening does
    if (access == Access::Existing && !std::filesystem::exists(file, unknown) && !unknown)
        throwInput(CULLSCOPE_TR("%1 cannot be opened: check the name and that you may read it."), {file.string()});
    const int mayMake = access == Access::Write ? SQLITE_OPEN_CREATE : 0;
    sqlite3* handle = nullptr;
    // A name that begins with "file:" or is ":memory:" is a file's name, too.
    const std::string name = file.is_absolute() ? file.string() : "./" + file.string();
    const int opened = sqlite3_open_v2(name.c_str(), &handle, SQLITE_OPEN_READWRITE | SQLITE_OPEN_EXRESCODE | mayMake, nullptr);
    m_handle.reset(handle);
    if (access == Access::Existing && (opened != SQLITE_OK || !isReadable()))
        openToRead();
    else if (opened != SQLITE_OK)
        fail(opened);
    handle = m_handle.get();
    sqlite3_busy_timeout(handle, int(kPatience.count()));
    // What a file claims of itself is not trusted: its text must not call functions, nor may writing change its pages by hand.
    sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
    run("PRAGMA cell_size_check = ON");
}

bool Database::isReadable() const {
    // To read a log SQLite writes an index of it beside the file.
    const int answer = sqlite3_exec(m_handle.get(), "PRAGMA schema_version", nullptr, nullptr, nullptr) & 0xff;
    return answer != SQLITE_IOERR && answer != SQLITE_FULL && answer != SQLITE_READONLY && answer != SQLITE_CANTOPEN &&
           answer != SQLITE_PERM;
}

void Database::openToRead() {
    std::string name = "file:";
    for (const char letter : std::filesystem::absolute(m_file).string()) {
        constexpr std::string_view kOfAddresses = "%?#";
        if (kOfAddresses.find(letter) == std::string_view::npos)
            name += letter;
        else
            name += fmt::format("%{:02X}", int(letter));
    }
    // Without a log nothing else is written or locked.
    std::error_code none;
    const auto log = std::filesystem::file_size(m_file.string() + "-wal", none);
    name += none || log == 0 ? "?mode=ro&immutable=1" : "?mode=ro";
    sqlite3* handle = nullptr;
    const int opened =
        sqlite3_open_v2(name.c_str(), &handle, SQLITE_OPEN_READONLY | SQLITE_OPEN_EXRESCODE | SQLITE_OPEN_URI, nullptr);
    m_handle.reset(handle);
    if (opened != SQLITE_OK) fail(opened);
}

void Database::run(const char* sql) const {
    if (const int answer = sqlite3_exec(m_handle.get(), sql, nullptr, nullptr, nullptr); answer != SQLITE_OK) fail(answer);
}

void Database::useWriteAheadLog() const {
    // SQLite does not wait here for a program that does the same at this moment: it answers that the file is busy.
    const auto end = std::chrono::steady_clock::now() + kPatience;
    while (true) {
        const int answer = sqlite3_exec(m_handle.get(), "PRAGMA journal_mode = WAL", nullptr, nullptr, nullptr);
        if (answer == SQLITE_OK) return;
        if ((answer & 0xff) != SQLITE_BUSY || std::chrono::steady_clock::now() >= end) fail(answer);
        std::this_thread::sleep_for(kBetweenTries);
    }
}

int64_t Database::newestRow() const { return sqlite3_last_insert_rowid(m_handle.get()); }

void Database::refuse() const {
    throwInput(CULLSCOPE_TR("%1 is no result store, or is damaged. Name another file."), {m_file.string()});
}

void Database::fail(int answer) const {
    const int system = m_handle ? sqlite3_system_errno(m_handle.get()) : 0;
    switch (answer & 0xff) {
        case SQLITE_NOMEM:
            throw std::bad_alloc();
        case SQLITE_BUSY:
        case SQLITE_LOCKED:
            throwUsage(CULLSCOPE_TR("%1 is in use: another program has been writing to it for half a minute."),
                       {m_file.string()});
        case SQLITE_FULL:
            throwUsage(CULLSCOPE_TR("%1 cannot be written: %2. What was stored before is there."),
                       {m_file.string(), systemReason(ENOSPC)});
        case SQLITE_IOERR:
        case SQLITE_READONLY:
        case SQLITE_PERM:
            throwUsage(CULLSCOPE_TR("%1 cannot be written: %2. What was stored before is there."),
                       {m_file.string(), systemReason(system != 0 ? system : EACCES)});
        case SQLITE_CANTOPEN:
            throwUsage(CULLSCOPE_TR("The result store %1 cannot be opened: %2."),
                       {m_file.string(), systemReason(system != 0 ? system : ENOENT)});
        default:
            refuse();
    }
}

Statement::Statement(const Database& database, const char* sql) : m_database(database) {
    sqlite3_stmt* handle = nullptr;
    const int answer = sqlite3_prepare_v2(database.m_handle.get(), sql, -1, &handle, nullptr);
    m_handle.reset(handle);
    if (answer != SQLITE_OK) database.fail(answer);
}

Statement& Statement::bind(std::string_view text) {
    const int answer = sqlite3_bind_text(m_handle.get(), ++m_bound, text.data(), static_cast<int>(text.size()), SQLITE_TRANSIENT);
    if (answer != SQLITE_OK) m_database.fail(answer);
    return *this;
}

Statement& Statement::bind(int64_t number) {
    if (const int answer = sqlite3_bind_int64(m_handle.get(), ++m_bound, number); answer != SQLITE_OK) m_database.fail(answer);
    return *this;
}

Statement& Statement::bindNothing() {
    if (const int answer = sqlite3_bind_null(m_handle.get(), ++m_bound); answer != SQLITE_OK) m_database.fail(answer);
    return *this;
}

bool Statement::next() {
    const int answer = sqlite3_step(m_handle.get());
    if (answer != SQLITE_ROW && answer != SQLITE_DONE) m_database.fail(answer);
    return answer == SQLITE_ROW;
}

void Statement::run() {
    while (next()) {
    }
}

int64_t Statement::number(int column) const { return sqlite3_column_int64(m_handle.get(), column); }

std::string Statement::text(int column) const {
    const auto* text = static_cast<const char*>(sqlite3_column_blob(m_handle.get(), column));
    return text == nullptr ? std::string() : std::string(text, size_t(sqlite3_column_bytes(m_handle.get(), column)));
}

bool Statement::isNothing(int column) const { return sqlite3_column_type(m_handle.get(), column) == SQLITE_NULL; }

Transaction::Transaction(const Database& database, Purpose purpose) : m_database(database) {
    m_database.run(purpose == Purpose::Write ? "BEGIN IMMEDIATE" : "BEGIN");
}

Transaction::~Transaction() {
    if (!m_open) return;
    try {
        m_database.run("ROLLBACK");
    } catch (const std::exception&) {
        // SQLite has rolled back by itself, as it does when the disk is full.
        m_open = false;
    }
}

void Transaction::commit() {
    m_database.run("COMMIT");
    m_open = false;
}

}  // namespace cullscope::store
