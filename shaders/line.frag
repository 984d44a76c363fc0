// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
in vec4 line_color;
layout(location = 0) out vec4 color;

void main() { color = line_color; }
