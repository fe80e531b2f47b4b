// The few members of Raylib-cs that docs/engines/Raylib.md uses, by their names alone.
using System.Numerics;

namespace Raylib_cs
{
    public struct Color(byte r, byte g, byte b, byte a)
    {
        public byte R = r;
        public byte G = g;
        public byte B = b;
        public byte A = a;
    }

    public static class Raylib
    {
        public static void InitWindow(int width, int height, string title)
        {
        }

        public static bool WindowShouldClose() => true;

        public static float GetFrameTime() => 0;

        public static void BeginDrawing()
        {
        }

        public static void ClearBackground(Color color)
        {
        }

        public static void EndDrawing()
        {
        }

        public static void CloseWindow()
        {
        }

        public static void DrawLineV(Vector2 startPos, Vector2 endPos, Color color)
        {
        }

        public static void DrawCircleLinesV(Vector2 center, float radius, Color color)
        {
        }

        public static void DrawCircleV(Vector2 center, float radius, Color color)
        {
        }
    }
}
