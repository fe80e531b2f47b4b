using Farseer.Engine.Bodies;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Springs;

/// <content>Meshes with bodies that trees of joints hold.</content>
[NotState(Why.OfOneStep)]
internal sealed unsafe partial class SpringMesh
{
    /// <summary>How a slot's body is held, beside 0 and 1 of <see cref="SpringRow.HeldA"/>.</summary>
    private const int InTree = 2;

    private readonly Column<TreeSlots> _trees = new Column<TreeSlots>();
    private JointSolver? _joints;
    private int _treeCount;

    /// <summary>A tree moves its bodies by h·v₁ and nothing else.</summary>
    private bool IsPlain(int body, int moves) => moves != 0 && _held[_slots[body]] == InTree;

    /// <summary>The end as the line to it is reckoned: that of a plain one stays where it is.</summary>
    private EndState Seen(EndState end, int body, int moves)
    {
        if (IsPlain(body, moves))
        {
            end.VX = 0;
            end.VY = 0;
            end.W = 0;
        }

        return end;
    }

    /// <summary>
    /// Of a body that moves by h·v₁ a force at x + θh·vθ would take energy, for it moves half a substep further than the midpoint rule has
    /// it. Its velocities are those in the middle of the ways, so that θh(vθ - v) is what belongs there: it keeps the energy at every
    /// constant and vanishes at rest.
    /// </summary>
    private double PlainSpeed(in SpringRow row, in EndState a, in EndState b)
    {
        double speed = 0;
        if (IsPlain(row.Def.BodyA, row.MovesA))
        {
            speed -= (row.NormalX * a.VX) + (row.NormalY * a.VY) + (row.TurnA * a.W);
        }

        if (IsPlain(row.Def.BodyB, row.MovesB))
        {
            speed += (row.NormalX * b.VX) + (row.NormalY * b.VY) + (row.TurnB * b.W);
        }

        return speed;
    }

    private void Forget(int body)
    {
        _slots[body] = -1;
        _joints?.Responses.MarkStrung(body);
        int tree = _joints?.Responses.TreeOfBody(body) ?? -1;
        if (tree >= 0)
        {
            _joints!.Responses.MarkPulled(tree);
        }

        for (int i = 0; tree >= 0 && i < _joints!.Responses.SizeOf(tree); i++)
        {
            _slots[_joints.Responses.BodyOf(tree, i)] = -1;
        }
    }

    /// <summary>Where joints took part the new velocities hold their impulses as well; the joints will give these themselves.</summary>
    private void PushByImpulses(in Mesh mesh, SpringRow* rows, BodyStore bodies, double h)
    {
        double* sum = _image.Pointer;
        for (int i = 3 * mesh.FirstSlot; i < 3 * (mesh.FirstSlot + mesh.SlotCount); i++)
        {
            sum[i] = 0;
        }

        for (int i = 0; i < mesh.RowCount; i++)
        {
            ref SpringRow row = ref rows[_rows[mesh.FirstRow + i]];
            if (row.Saturated != 0)
            {
                AddTurn(row, sum, row.GivenA, row.GivenB);
                continue;
            }

            Add(row, sum, Impulse(row, mesh, bodies, h));
            double spin = -Spin(row, h);
            AddTurn(row, sum, spin * TurnOf(row.Def.BodyA, row.MovesA), spin * TurnOf(row.Def.BodyB, row.MovesB));
        }

        for (int slot = mesh.FirstSlot; slot < mesh.FirstSlot + mesh.SlotCount; slot++)
        {
            double* p = sum + (3 * slot);
            double* mass = _mass.Pointer + (3 * slot);
            Push(mesh, slot, bodies, p[0] / mass[0], p[1] / mass[1], p[2] / mass[2], h);
        }
    }

    /// <summary>Of gravity and forces on a tree its joints leave a part.</summary>
    private void StartTree(in Mesh mesh, in TreeSlots tree, BodyStore bodies)
    {
        int size = _joints!.Responses.SizeOf(tree.Tree);
        double* drive = _scaled.Pointer + (3 * tree.FirstSlot);
        for (int i = 0; i < size; i++)
        {
            ref BodyDrive from = ref bodies.Drive[_bodies[tree.FirstSlot + i]];
            drive[3 * i] = mesh.Theta * from.X;
            drive[(3 * i) + 1] = mesh.Theta * from.Y;
            drive[(3 * i) + 2] = mesh.Theta * from.W;
        }

        _joints.Responses.Project(tree.Tree, drive);
        for (int i = 0; i < size; i++)
        {
            EndState end = EndState.Read(bodies, _bodies[tree.FirstSlot + i], 1, 1);
            double* v = _velocity.Pointer + (3 * (tree.FirstSlot + i));
            v[0] = end.VX + drive[3 * i];
            v[1] = end.VY + drive[(3 * i) + 1];
            v[2] = end.W + drive[(3 * i) + 2];
        }
    }

    /// <summary>A tree of joints in a mesh: its bodies have slots in its own order.</summary>
    private struct TreeSlots
    {
        public int Tree;
        public int FirstSlot;
    }
}
