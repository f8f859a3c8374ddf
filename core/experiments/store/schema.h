#pragma once

#include <array>

namespace cullscope::store {

/// "Cull", by which SQLite's file says whose it is.
inline constexpr int kApplication = 0x43756c6c;

/// What makes each version of the layout of the one before; the first one of an empty file.
inline constexpr std::array<const char*, 4> kLayouts{
    R"(
CREATE TABLE measurement (
    number INTEGER PRIMARY KEY AUTOINCREMENT,
    started TEXT NOT NULL,
    ended TEXT,
    interrupted INTEGER NOT NULL,
    experiment TEXT NOT NULL,
    command TEXT NOT NULL,
    tool_name TEXT NOT NULL, tool_version TEXT NOT NULL, tool_commit TEXT NOT NULL,
    cpu TEXT NOT NULL, gl_renderer TEXT NOT NULL, gl_version TEXT NOT NULL, gl_software INTEGER NOT NULL,
    scene TEXT NOT NULL, scene_sha256 TEXT NOT NULL, triangles INTEGER NOT NULL, instances INTEGER NOT NULL,
    path TEXT NOT NULL, poses INTEGER NOT NULL, width INTEGER NOT NULL, height INTEGER NOT NULL
);
CREATE TABLE run (
    number INTEGER PRIMARY KEY AUTOINCREMENT,
    measurement INTEGER NOT NULL REFERENCES measurement (number),
    place INTEGER NOT NULL,
    strategy TEXT NOT NULL,
    asked_for INTEGER NOT NULL,
    is_limit INTEGER NOT NULL,
    head TEXT NOT NULL,
    UNIQUE (measurement, place)
);
CREATE TABLE frame (
    run INTEGER NOT NULL REFERENCES run (number),
    pose INTEGER NOT NULL,
    own_raster INTEGER NOT NULL,
    fields TEXT NOT NULL,
    frame_times TEXT NOT NULL,
    cull_times TEXT NOT NULL,
    PRIMARY KEY (run, pose)
) WITHOUT ROWID;
)",
    R"(
ALTER TABLE run ADD COLUMN figures TEXT;
CREATE INDEX measurement_by_time ON measurement (started);
CREATE TABLE certificate (
    number INTEGER PRIMARY KEY AUTOINCREMENT,
    added TEXT NOT NULL,
    strategy TEXT NOT NULL,
    document TEXT NOT NULL
);
)",
    R"(
ALTER TABLE frame ADD COLUMN judged TEXT;
)",
    R"(
CREATE TABLE report (
    number INTEGER PRIMARY KEY AUTOINCREMENT,
    added TEXT NOT NULL,
    kind TEXT NOT NULL,
    scene TEXT NOT NULL,
    strategy TEXT NOT NULL,
    command TEXT NOT NULL,
    words TEXT NOT NULL,
    document TEXT NOT NULL
);
INSERT INTO report SELECT number, added, 'certificate', '', strategy, '', '', document FROM certificate;
DROP TABLE certificate;
)"};

}  // namespace cullscope::store
