#include "desktop/keys.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

namespace normalscope {
namespace {

TEST(Keys, GoByWhatIsPrintedOnThem) {
    EXPECT_EQ(key_of(GLFW_KEY_A, "a", 0), ImGuiKey_A);
    EXPECT_EQ(key_of(GLFW_KEY_Q, "a", ImGuiMod_Ctrl), ImGuiKey_A);          // French
    EXPECT_EQ(key_of(GLFW_KEY_Y, "z", ImGuiMod_Ctrl), ImGuiKey_Z);          // German
    EXPECT_EQ(key_of(GLFW_KEY_SEMICOLON, "m", 0), ImGuiKey_M);              // French
    EXPECT_EQ(key_of(GLFW_KEY_M, ",", 0), ImGuiKey_Comma);                  // French
    EXPECT_EQ(key_of(GLFW_KEY_SLASH, "-", ImGuiMod_Ctrl), ImGuiKey_Minus);  // German
    EXPECT_EQ(key_of(GLFW_KEY_RIGHT_BRACKET, "+", ImGuiMod_Ctrl), ImGuiKey_Equal);
}

TEST(Keys, DigitsGoByTheirPlace) {
    EXPECT_EQ(key_of(GLFW_KEY_1, "&", 0), ImGuiKey_1);  // French
    EXPECT_EQ(key_of(GLFW_KEY_6, "-", 0), ImGuiKey_6);
    EXPECT_EQ(key_of(GLFW_KEY_6, "-", ImGuiMod_Ctrl), ImGuiKey_Minus);  // smaller
    EXPECT_EQ(key_of(GLFW_KEY_0, "\u00e0", ImGuiMod_Ctrl), ImGuiKey_0);
    EXPECT_EQ(key_of(GLFW_KEY_KP_5, "5", 0), ImGuiKey_Keypad5);
}

TEST(Keys, WhatPrintsNoLatinLetterGoesByItsPlace) {
    EXPECT_EQ(key_of(GLFW_KEY_Z, "\u044f", ImGuiMod_Ctrl), ImGuiKey_Z);  // Russian
    EXPECT_EQ(key_of(GLFW_KEY_PERIOD, ":", 0), ImGuiKey_Period);         // French: what a remote control sends
    EXPECT_EQ(key_of(GLFW_KEY_W, "", 0), ImGuiKey_W);
    EXPECT_EQ(key_of(GLFW_KEY_PAGE_DOWN, "", 0), ImGuiKey_PageDown);
    EXPECT_EQ(key_of(GLFW_KEY_F5, "", 0), ImGuiKey_F5);
    EXPECT_EQ(key_of(GLFW_KEY_KP_SUBTRACT, "-", 0), ImGuiKey_KeypadSubtract);
    EXPECT_EQ(key_of(GLFW_KEY_UNKNOWN, "", 0), ImGuiKey_None);
}

}  // namespace
}  // namespace normalscope
