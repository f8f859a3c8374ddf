// The precompiled header of the desktop's tests: that of the other tests, and Qt Widgets.
#pragma once

#include <QtWidgets>

#include "tests/precompiled.h"
