using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace Farseer.Engine.Numerics;

/// <summary>A rotation by its cosine and sine.</summary>
[StructLayout(LayoutKind.Sequential)]
internal struct Rotation
{
    public float Cos;
    public float Sin;

    public Rotation(float cos, float sin)
    {
        Cos = cos;
        Sin = sin;
    }

    public static Rotation Identity => new Rotation(1, 0);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly Vector2 Rotate(Vector2 v) => new Vector2((Cos * v.X) - (Sin * v.Y), (Sin * v.X) + (Cos * v.Y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly Vector2 InverseRotate(Vector2 v) => new Vector2((Cos * v.X) + (Sin * v.Y), (Cos * v.Y) - (Sin * v.X));

    /// <summary>The rotation by this one and then the inverse of <paramref name="b"/>'s frame: b⁻¹·this.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly Rotation RelativeTo(Rotation b) => new Rotation((b.Cos * Cos) + (b.Sin * Sin), (b.Cos * Sin) - (b.Sin * Cos));
}
