// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// A photo or a scan behind everything.
uniform sampler2D picture;  // colours times their alpha
uniform float opacity;

in vec2 place;

layout(location = 0) out vec4 color;

void main() { color = opacity * texture(picture, place); }
