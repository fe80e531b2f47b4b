// The few members of Godot that docs/engines/Godot.md uses, by their names alone.
namespace Godot
{
    public struct Vector2(float x, float y)
    {
        public float X = x;
        public float Y = y;
    }

    public struct Color
    {
        public static Color Color8(byte r8, byte g8, byte b8, byte a8 = 255) => default;
    }

    public static class Mathf
    {
        public const float Tau = 6.2831853f;
    }

    public class Node2D
    {
        public virtual void _PhysicsProcess(double delta)
        {
        }

        public virtual void _Draw()
        {
        }

        public void QueueRedraw()
        {
        }

        public void DrawLine(Vector2 from, Vector2 to, Color color, float width = -1, bool antialiased = false)
        {
        }

        public void DrawArc(Vector2 center, float radius, float startAngle, float endAngle, int pointCount, Color color, float width = -1)
        {
        }

        public void DrawCircle(Vector2 position, float radius, Color color)
        {
        }
    }
}
