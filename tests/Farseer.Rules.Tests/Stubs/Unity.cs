// The few members of Unity that docs/engines/Unity.md uses, by their names alone.
namespace UnityEngine
{
    public struct Vector3(float x, float y, float z)
    {
        public float x = x;
        public float y = y;
        public float z = z;
    }

    public struct Color
    {
    }

    public struct Color32(byte r, byte g, byte b, byte a)
    {
        public byte r = r;
        public byte g = g;
        public byte b = b;
        public byte a = a;

        public static implicit operator Color(Color32 color) => default;
    }

    public class MonoBehaviour
    {
    }

    public static class Time
    {
        public static float time => 0;

        public static float fixedTime => 0;

        public static float fixedDeltaTime => 0.02f;
    }

    public static class Gizmos
    {
        public static Color color { get; set; }

        public static void DrawLine(Vector3 from, Vector3 to)
        {
        }

        public static void DrawWireSphere(Vector3 center, float radius)
        {
        }
    }
}
