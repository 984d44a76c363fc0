// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// Where the surface turns away, edges of its far side would show past the outline, and near ones crowd: both fade.
uniform float past_outline;  // what is left where there is no surface

float share_facing(vec3 normal) {
  return normal == vec3(0.0) ? past_outline : smoothstep(0.0, 0.2, normal.z);
}
