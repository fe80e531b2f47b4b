using System.Runtime.CompilerServices;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Contacts;

/// <summary>
/// Surfaces far from their bodies. A lever has the arm T along the surface, which answers, and N across it; R = i·r²/m is what a point
/// answers by turning to what it answers by moving. A sweep with arms turned by φ leaves i·T·N·sin φ/(m + i·T²) of an error, at most
/// ½·√R·sin φ: of whatever T, for that of a far surface changes by N·φ with each turn. Boxes and rods have R ≤ 3, and others leave no more
/// than those at <see cref="TurnedArms.LargestSine"/> if their arms turn by √(3/R) of it. At R = 10⁶ an error grew a hundredfold in each
/// sweep, and bodies left at 10¹³ m/s.
/// </summary>
internal static unsafe class FarSurfaces
{
    /// <summary>R from which on surfaces are far: no body has it that is as large as its shapes.</summary>
    private const float Far = 9f;

    /// <summary>R of rods, the largest of bodies that are as large as their shapes.</summary>
    private const float Usual = 3f;

    private const float LeastResponse = 1e-30f;

    /// <summary>Lanes with a point whose lever is far.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideMask AreFar(ContactBundle* row, int lane, Wide mass) => Turning(row, lane) > Wide.Splat(Far) * mass;

    /// <summary>The sine of the largest turn of arms.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide LargestSine(ContactBundle* row, int lane) => Wide.Splat(TurnedArms.LargestSine) * PushShare(row, lane);

    /// <summary>
    /// The share of an overlap that goes of what goes elsewhere. A push of s turns the body by i·T·s/K, and the surface along by N times
    /// that, ½·√R·s at most: a floor ends, and lever and overlap are others there.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide PushShare(ContactBundle* row, int lane)
    {
        Wide mass = Wide.Load(row->MassA + lane) + Wide.Load(row->MassB + lane);
        Wide turning = Wide.Max(Turning(row, lane), Wide.Splat(LeastResponse));
        return Wide.Select(
            ContactBundle.Has(row, lane, ContactBundle.FarMark), Wide.Sqrt(Wide.Splat(Usual) * mass / turning), Wide.One);
    }

    /// <summary>i·r² of both bodies, of the point with the longer levers.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Wide Turning(ContactBundle* row, int lane)
    {
        Wide a = Wide.Max(
            Square(row->Point0.TangentArmA, row->Point0.NormalArmA, lane), Square(row->Point1.TangentArmA, row->Point1.NormalArmA, lane));
        Wide b = Wide.Max(
            Square(row->Point0.TangentArmB, row->Point0.NormalArmB, lane), Square(row->Point1.TangentArmB, row->Point1.NormalArmB, lane));
        return (Wide.Load(row->InertiaA + lane) * a) + (Wide.Load(row->InertiaB + lane) * b);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Wide Square(float* tangent, float* normal, int lane)
    {
        Wide t = Wide.Load(tangent + lane);
        Wide n = Wide.Load(normal + lane);
        return (t * t) + (n * n);
    }
}
