// The few members of MonoGame, KNI and FNA that docs/engines/MonoGame.md uses, by their names alone.
using System;

namespace Microsoft.Xna.Framework
{
    public class Game
    {
        public bool IsFixedTimeStep { get; set; }

        protected virtual void Initialize()
        {
        }

        protected virtual void Update(GameTime gameTime)
        {
        }
    }

    public class GameTime
    {
        public TimeSpan ElapsedGameTime { get; set; }
    }

    public struct Vector3(float x, float y, float z)
    {
        public float X = x;
        public float Y = y;
        public float Z = z;
    }

    public struct Color(int r, int g, int b, int alpha)
    {
        public byte R { get; set; } = (byte)r;

        public byte G { get; set; } = (byte)g;

        public byte B { get; set; } = (byte)b;

        public byte A { get; set; } = (byte)alpha;
    }

    public struct Matrix
    {
    }
}

namespace Microsoft.Xna.Framework.Graphics
{
    public enum PrimitiveType
    {
        LineList,
    }

    public struct VertexPositionColor(Vector3 position, Color color)
    {
        public Vector3 Position = position;
        public Color Color = color;
    }

    public class GraphicsDevice
    {
        public void DrawUserPrimitives<T>(PrimitiveType primitiveType, T[] vertexData, int vertexOffset, int primitiveCount)
            where T : struct
        {
        }
    }

    public class BasicEffect(GraphicsDevice device)
    {
        public GraphicsDevice GraphicsDevice { get; } = device;

        public bool VertexColorEnabled { get; set; }

        public Matrix Projection { get; set; }

        public EffectTechnique CurrentTechnique { get; } = new();
    }

    public class EffectTechnique
    {
        public EffectPass[] Passes { get; } = [new()];
    }

    public class EffectPass
    {
        public void Apply()
        {
        }
    }
}
