#version 330 core
#ifdef GL_ARB_gpu_shader_fp64
#extension GL_ARB_gpu_shader_fp64 : enable
#endif
precision highp float;
precision highp int;
