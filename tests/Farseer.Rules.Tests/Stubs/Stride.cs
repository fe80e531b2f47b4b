// The few members of Stride that docs/engines/Stride.md uses, by their names alone.
using System;

namespace Stride.Core.Mathematics
{
    public struct Vector2(float x, float y)
    {
        public float X = x;
        public float Y = y;
    }

    public struct RectangleF(float x, float y, float width, float height)
    {
        public float X = x;
        public float Y = y;
        public float Width = width;
        public float Height = height;
    }

    public struct Color4(float red, float green, float blue, float alpha)
    {
        public float R = red;
        public float G = green;
        public float B = blue;
        public float A = alpha;
    }
}

namespace Stride.Graphics
{
    using Stride.Core.Mathematics;

    public class Texture
    {
    }

    public enum SpriteEffects
    {
        None,
    }

    public class SpriteBatch
    {
        public void Draw(
            Texture texture, RectangleF destinationRectangle, RectangleF? sourceRectangle, Color4 color, float rotation,
            Vector2 origin, SpriteEffects effects = SpriteEffects.None)
        {
        }
    }
}

namespace Stride.Engine
{
    public class GameTime
    {
        public TimeSpan Elapsed => default;
    }

    public class IGame
    {
        public GameTime UpdateTime { get; } = new();
    }

    public abstract class SyncScript
    {
        public IGame Game { get; } = new();

        public virtual void Start()
        {
        }

        public abstract void Update();
    }
}
