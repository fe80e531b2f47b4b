namespace Microsoft.Xna.Framework
{
    public struct Vector2
    {
    }

    public struct Vector3
    {
        public float Depth;
    }

    public struct Matrix
    {
    }

    public static class MathHelper
    {
    }

    public class Curve
    {
    }

    public enum CurveTangent
    {
        OfTheFramework,
    }
}
