using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Islands;

/// <summary>
/// Most changes of the graph are neighbours in a layer that begin or cease to touch: they alter no level, and part or join no
/// island. Such changes are seen through one by one, with the search of the last <see cref="Build"/>; any other asks for a new one.
/// </summary>
internal sealed unsafe partial class IslandStore
{
    private int _bodyEnd;

    /// <summary>Brings islands and levels up to date if the changes of the graph altered neither.</summary>
    /// <returns>False if they have to be built anew.</returns>
    /// <param name="graph">The rows, and what came and went.</param>
    /// <param name="records">Where they are.</param>
    /// <param name="moves">1 for a body that can move.</param>
    public bool Keep(ConstraintGraph graph, Column<ContactRecord> records, byte* moves)
    {
        if (_bodyEnd == 0 || !graph.ChangesAreKnown)
        {
            return false;
        }

        GraphChange* changes = graph.Changes;
        int count = graph.ChangeCount;
        for (int i = 0; i < count; i++)
        {
            int a = changes[i].BodyA;
            int b = changes[i].BodyB;
            if (a >= _bodyEnd || b >= _bodyEnd)
            {
                return false;
            }

            bool harmless = changes[i].Contact == GraphChange.Gone ? MayGo(a, b, moves) : MayCome(a, b, moves);
            if (!harmless)
            {
                return false;
            }
        }

        for (int i = 0; i < count; i++)
        {
            int contact = changes[i].Contact;
            int body = moves[changes[i].BodyA] != 0 ? changes[i].BodyA : changes[i].BodyB;
            if (_islandOf[body] >= 0)
            {
                _rowsOf[_islandOf[body]] += contact == GraphChange.Gone ? -1 : 1;
            }

            if (contact != GraphChange.Gone && records[contact].Color >= 0 && records[contact].Color < ConstraintGraph.ColorCount)
            {
                WriteLane(graph.BundleOf(records[contact].Row), RowArena.LaneOf(records[contact].Row), moves);
            }
        }

        return true;
    }

    /// <summary>
    /// A new contact within an island between bodies whose levels differ by at most one shortens no way to the ground; and a body
    /// that stands on the ground already may stand on more of it.
    /// </summary>
    private bool MayCome(int a, int b, byte* moves)
    {
        if ((moves[a] & moves[b]) == 0)
        {
            int body = moves[a] != 0 ? a : b;
            return moves[body] != 0 && _islandOf[body] >= 0 && _level[body] == 0;
        }

        int difference = _level[a] - _level[b];
        bool carried = _level[a] >= 0 && _level[b] >= 0;
        return _islandOf[a] >= 0 && _islandOf[a] == _islandOf[b]
            && (carried ? difference >= -1 && difference <= 1 : difference == 0);
    }

    /// <summary>
    /// Bodies of one level support each other in nothing. Where both still touch a third one, the island holds together. Contacts
    /// that went are struck off the lists of neighbours, and those that came are not on them: so no way is seen that is not there.
    /// </summary>
    private bool MayGo(int a, int b, byte* moves)
    {
        if ((moves[a] & moves[b]) == 0 || _islandOf[a] < 0 || _islandOf[a] != _islandOf[b] || _level[a] != _level[b])
        {
            return false;
        }

        Strike(a, b);
        Strike(b, a);
        int* neighbours = _neighbours.Pointer;
        for (int i = _begin[a]; i < _end[a]; i++)
        {
            for (int k = _begin[b]; k < _end[b]; k++)
            {
                if (neighbours[i] == neighbours[k] && neighbours[i] >= 0)
                {
                    return true;
                }
            }
        }

        return false;
    }

    private void Strike(int body, int other)
    {
        int* neighbours = _neighbours.Pointer;
        for (int k = _begin[body]; k < _end[body]; k++)
        {
            if (neighbours[k] == other)
            {
                neighbours[k] = -1;
                return;
            }
        }
    }
}
