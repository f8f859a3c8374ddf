// What nearly every test of the desktop includes, parsed once.
#pragma once

#include <QtTest>

#include "tests/precompiled.h"
#include "ui/precompiled.h"
