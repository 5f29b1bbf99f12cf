#version 330 core
precision highp float;
precision highp int;
